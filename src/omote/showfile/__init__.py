"""The show file: one SQLite file with the journal of the live state and all authored work."""
