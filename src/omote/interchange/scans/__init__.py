"""Reads scans and pictures that were made elsewhere, from untrusted bytes."""
