"""Devices at pages (MIDI, gamepads, space mice) at a show: what pages send in, what plays and is told out."""
