"""Microphones of pages."""
