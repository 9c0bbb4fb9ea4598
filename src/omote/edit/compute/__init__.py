"""Performs editors' orders and makes the documents that an editor is welcomed with."""
