"""What is told of a character beside what it shows."""
