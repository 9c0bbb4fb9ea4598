"""Gestures: short motions of head and brows that are called by name."""
