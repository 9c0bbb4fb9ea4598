"""Synthetic voices: their phones as visemes with times, and what a voice that speaks a text gives."""
