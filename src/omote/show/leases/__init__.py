"""Who may command which part of a character."""
