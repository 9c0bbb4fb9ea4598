"""The figures of docs/method.md, drawn from the code's own numbers."""
