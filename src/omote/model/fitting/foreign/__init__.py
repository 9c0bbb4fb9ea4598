"""Shapes of strangers' heads as expressions of ours."""
