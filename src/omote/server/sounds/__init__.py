"""Sounds that characters speak with, kept for stages."""
