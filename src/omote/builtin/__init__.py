"""The baked cast."""
