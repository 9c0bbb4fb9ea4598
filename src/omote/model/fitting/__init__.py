"""Fits the generic head to scans, strangers' meshes and photographs."""
