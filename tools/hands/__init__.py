"""Hands of ours before a camera: the rig of the CC0 body, posed, lit and filmed."""
