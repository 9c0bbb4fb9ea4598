"""What is on air, for other programs that draw faces."""
