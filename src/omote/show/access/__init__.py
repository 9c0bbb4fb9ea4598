"""Who may play a show: people with tokens, and what each role may do."""
