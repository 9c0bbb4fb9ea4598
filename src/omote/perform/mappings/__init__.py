"""Mappings: one number under a hand that plays several targets of a character, each by a curve of its own."""
