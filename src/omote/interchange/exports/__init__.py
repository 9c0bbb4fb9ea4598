"""Files for other programs: USD, OBJ, and the table of all formats."""
