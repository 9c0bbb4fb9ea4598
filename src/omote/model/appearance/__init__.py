"""What a certain person looks like: colours of the skin taken over from scans and pictures."""
