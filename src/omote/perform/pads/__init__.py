"""Pads (blend spaces): looks at places, and a point moved among them whose mixture an axis of a character shows."""
