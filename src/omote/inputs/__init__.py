"""Decoders of what devices and other programs send, without input or output.

What cannot be obeyed is rejected with a reason and counted; no packet raises anything else.
"""
