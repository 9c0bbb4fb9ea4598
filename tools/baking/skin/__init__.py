"""Paints the skin's layers of the built-in cast."""
