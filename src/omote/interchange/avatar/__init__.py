"""Exports faces as avatars: VRM 1.0 with a plain skeleton, expressions and terms of use."""
