"""Decoders of what face trackers send."""
