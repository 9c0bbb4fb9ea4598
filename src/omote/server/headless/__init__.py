"""Draws pictures in a Chromium without a window."""
