"""Clips for other programs, and recordings of others as clips."""
