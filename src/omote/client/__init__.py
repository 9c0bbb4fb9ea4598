"""A program's own link to a running show."""
