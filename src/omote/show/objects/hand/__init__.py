"""What a hand plays many things with at once: pads."""
