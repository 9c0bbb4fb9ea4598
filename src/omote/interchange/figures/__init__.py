"""Figures, head and body, on a skeleton that other programs pose."""
