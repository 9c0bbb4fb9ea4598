"""What addresses of OSC are made of, and those of speech."""
