"""Sounds that programs send."""
