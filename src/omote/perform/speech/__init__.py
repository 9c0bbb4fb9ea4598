"""Speech: mouth shapes in time."""
