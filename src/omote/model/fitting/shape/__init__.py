"""How the generic head takes the shape of a scan."""
