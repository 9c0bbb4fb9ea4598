"""Recordings of trackers."""
