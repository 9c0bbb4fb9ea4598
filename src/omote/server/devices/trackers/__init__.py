"""Sockets of face trackers."""
