"""Authoring without input or output: bytes of editors in, orders, changes and answers out."""
