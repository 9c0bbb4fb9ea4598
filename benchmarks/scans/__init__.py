"""Heads that nobody here made, as scans, and what fits of them are measured by."""
