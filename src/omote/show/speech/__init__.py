"""Sounds that characters speak with: which are there, and which stage plays them."""
