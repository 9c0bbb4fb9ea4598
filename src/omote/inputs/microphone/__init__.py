"""Lips from a voice."""
