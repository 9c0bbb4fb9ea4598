"""A show without input or output: messages and a time in, messages out."""
