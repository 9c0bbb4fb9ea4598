"""Bindings of devices' controls to what they play, without input or output."""
