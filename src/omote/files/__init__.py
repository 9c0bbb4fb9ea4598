"""The show file."""
