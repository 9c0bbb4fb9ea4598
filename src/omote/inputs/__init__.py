"""Decoders of what devices and other programs send, without input or output."""
