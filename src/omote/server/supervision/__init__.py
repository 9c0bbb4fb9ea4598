"""Keeps a show process playing and replaces it within milliseconds when it dies."""
