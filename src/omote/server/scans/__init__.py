"""Scans that pages bring: looked at, corrected by clicks, taken as faces or thrown away."""
