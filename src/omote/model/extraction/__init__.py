"""From a displacement of a face to an expression: the inverse of a compound."""
