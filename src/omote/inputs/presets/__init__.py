"""Presets: what the controls of common devices play as soon as they are plugged in."""
