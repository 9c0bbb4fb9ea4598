"""Lids of a scan: where their edges are seen, and how far a shape of it shuts them."""
