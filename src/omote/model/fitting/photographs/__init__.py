"""Faces from photographs whose landmarks are known."""
