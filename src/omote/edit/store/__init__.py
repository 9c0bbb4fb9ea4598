"""All authored work as it is now, and the contents that recipes refer to."""
