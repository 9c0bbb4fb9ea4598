"""Writes docs/expression.schema.json from the types in interchange/formats/expression_json.py."""

from omote.interchange.formats.expression_json import schema
from tools.node import ROOT

SCHEMA = ROOT / "docs" / "expression.schema.json"


def main() -> None:
    """Writes it."""
    SCHEMA.write_bytes(schema())


if __name__ == "__main__":
    main()
