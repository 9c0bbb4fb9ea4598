"""Motion clips: recorded curves of a character in lanes, and who plays them."""
