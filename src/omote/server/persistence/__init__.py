"""Writes and restores the show file beside the show."""
