"""Writes docs/expression.schema.json from the types in files/exchange.py."""

from omote.files.exchange import schema
from tools.node import ROOT

SCHEMA = ROOT / "docs" / "expression.schema.json"


def main() -> None:
    """Writes it."""
    SCHEMA.write_bytes(schema())


if __name__ == "__main__":
    main()
