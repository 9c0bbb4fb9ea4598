"""The nouns of a show, a module each: commands, what the server tells, what is stored."""
