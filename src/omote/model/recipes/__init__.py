"""Recipes of authored expressions and faces as plain data, and what they compose to."""
