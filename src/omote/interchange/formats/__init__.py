"""Reads and writes single file formats: glTF binary, OBJ, PNG, JSON, TOML."""
