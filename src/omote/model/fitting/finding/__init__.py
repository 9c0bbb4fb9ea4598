"""Finds where in a scan a head is."""
