"""Layers: sources, called expressions and hands mixed by followed influences."""
