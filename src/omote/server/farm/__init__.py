"""Exports many faces at once: in processes of this machine, or on a cluster."""
