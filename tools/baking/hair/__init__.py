"""Grows the hair styles of the built-in cast."""
