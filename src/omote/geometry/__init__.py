"""Meshes and the mathematics on them; knows nothing of faces."""
