"""Figures in motion: mixes of poses and bodies, legs that reach their feet, and the skin of it all."""
