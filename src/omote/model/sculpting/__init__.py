"""Makes new faces: sculpts, regional mixes, caricature."""
