"""What a hand plays many things with at once: pads, macros, and set-ups of both and of bindings."""
