"""Omote plays faces live: any face wears any expression, and both change at any instant."""

__version__ = "0.1.0"
