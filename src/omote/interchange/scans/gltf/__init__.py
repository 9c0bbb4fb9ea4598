"""Reads scans from glTF files: what a viewer shows of them at rest."""
