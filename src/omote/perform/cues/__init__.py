"""Cue lists: what a show has prepared, called one after the other by GO."""
