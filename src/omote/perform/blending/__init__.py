"""Evaluates a frame: blends compounds, applies correctives, gives positions."""
