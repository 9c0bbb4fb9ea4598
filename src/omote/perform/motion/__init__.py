"""Automatic motion: blinks, gaze, breath and small noise that a character makes by itself, deterministic and seeded."""
