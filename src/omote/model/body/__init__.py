"""Bodies: one skeleton and one mesh below the head, of which each body is a global deformation."""
