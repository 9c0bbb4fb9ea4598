"""Proves that a refactoring changed no behaviour: `python -m tools.same record FILE`, then `compare FILE`."""
