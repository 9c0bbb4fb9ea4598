"""Faces and expressions out to other programs and in from them."""
