"""Maps that carry an expression from the generic face to another, and what is measured on them."""
