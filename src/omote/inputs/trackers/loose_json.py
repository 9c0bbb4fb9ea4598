"""JSON as strangers write it: another country's decimals, NaN, a mark of byte order, names of fields in any case."""

from __future__ import annotations

import json
import math
import re
from typing import Any

from omote.interchange.formats.file_content import strip_mark

DECIMAL_COMMA = re.compile(r"(:\s*-?\d+),(\d+(?:[eE][-+]?\d+)?\s*[,}\]])")
"""Behind a colon a number is followed by a name in quotes, never by digits."""
SIGNS = str.maketrans({"\u2212": "-", "\u066b": "."})
"""What some countries write for a minus and for the point of decimals."""


def load_loosely(data: bytes) -> Any:
    """The document, numbers as floats; None where it is none."""
    try:
        return json.loads(DECIMAL_COMMA.sub(r"\1.\2", read_text(data)), parse_int=float)
    except (ValueError, RecursionError):
        return None


def read_text(data: bytes) -> str:
    """A text in UTF-8, or UTF-16 with its mark, without that; what is neither becomes a sign of replacement."""
    return strip_mark(data).decode(errors="replace").translate(SIGNS)


def find_field(document: Any, name: str, default: Any = None) -> Any:
    """A field of a document.

    name: in small letters; the document may have it in capitals and with underscores; default: where there is none.
    """
    if not isinstance(document, dict):
        return default
    return next((value for key, value in document.items() if key.replace("_", "").lower() == name), default)


def read_number(value: Any) -> float:
    """A number, of a text too; NaN where it is none."""
    try:
        return float(value.strip().translate(SIGNS).replace(",", ".") if isinstance(value, str) else value)
    except (TypeError, ValueError):
        return math.nan


def read_pairs(listed: Any, name: str, value: str) -> dict[str, float]:
    """Numbers by their names, of a list of documents with a field for each, or of one document with all.

    listed: the list or the document; name, value: the fields.
    """
    if isinstance(listed, dict):
        pairs = [*listed.items()]
    else:
        pairs = (
            [(find_field(each, name), find_field(each, value)) for each in listed] if isinstance(listed, list) else []
        )
    return {key: read_number(number) for key, number in pairs if key and isinstance(key, str)}
