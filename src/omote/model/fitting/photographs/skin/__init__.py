"""What photographs show of the skin, as evidence for the shape of a face."""
