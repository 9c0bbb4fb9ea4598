"""Several characters on one stage."""
