"""Says in plain words what the bytes of a file are, for people who gave another one than was expected."""

from __future__ import annotations

import codecs
from collections.abc import Mapping

import msgspec

BEGINNINGS: Mapping[bytes, str] = {
    b"\x89PNG": "a picture (PNG)",
    b"\xff\xd8\xff": "a picture (JPEG)",
    b"GIF8": "a picture (GIF)",
    b"BM": "a picture (BMP)",
    b"RIFF": "a picture, a sound or a film (RIFF)",
    b"%PDF": "a document (PDF)",
    b"SQLite format 3": "a show file or another database",
    b"glTF": "a glTF binary (.glb)",
    b"Kaydara FBX": "an FBX file",
    b"BLENDER": "a Blender file",
    b"PK\x03\x04": "an archive (ZIP)",
    b"\x1f\x8b": "an archive (GZIP)",
}
"""What files that people confuse begin with."""
BRANDS: Mapping[tuple[bytes, ...], str] = {
    (b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1"): "a picture (HEIC)",
    (b"avif", b"avis"): "a picture (AVIF)",
}
"""What files are whose first box names a brand (ISO base media), by the brand."""
READ = 4096
"""Bytes that tell text from other things."""
_VERTEX = (b"v ", b"v\t")


MARKS = (codecs.BOM_UTF8, codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
"""Marks of byte order, with which texts may begin."""


def describe_content(data: bytes, /) -> str:
    """What a file is by its bytes, as a noun: "a picture (PNG)", "an empty file"."""
    if not data.strip():
        return "an empty file"
    known = next((what for beginning, what in BEGINNINGS.items() if data.startswith(beginning)), None)
    if known is not None:
        return known
    begin = data[:READ]
    if begin[4:8] == b"ftyp":
        return next((what for brand, what in BRANDS.items() if begin[8:12] in brand), "a film (MP4)")
    if begin.lstrip()[:1] in (b"{", b"["):
        return "JSON"
    if b"\0" in begin or not _is_text(begin):
        return "binary data of another kind"
    if any(line.lstrip()[:2] in _VERTEX for line in data.splitlines()[:1000]):
        return "a shape (OBJ)"
    return "text"


def strip_mark(text: bytes, /) -> bytes:
    """A text as UTF-8 without marks of byte order, which programs write before texts and what they add to them."""
    for mark, encoding in ((codecs.BOM_UTF16_LE, "utf-16-le"), (codecs.BOM_UTF16_BE, "utf-16-be")):
        if text.startswith(mark):
            text = text.decode(encoding, "replace").encode()
    return text.replace(codecs.BOM_UTF8, b"")


def explain_syntax(data: bytes, /) -> str | None:
    """Why bytes are no JSON and what to do, as a clause; None where they are."""
    try:
        msgspec.json.decode(data)
    except RecursionError:
        return None  # too deep for a document, which its reader says
    except (msgspec.DecodeError, UnicodeDecodeError) as error:
        what = describe_content(data)
        if what != "JSON":
            return f"it is {what}"
        lines = data.count(b"\n") + 1
        if "truncated" in str(error):
            return f"it is cut off after {len(data)} bytes, in line {lines}: copy or export it anew"
        return f"it is no JSON from {_place(data, str(error))} on: export it anew, or mend it there"
    return None


def _place(data: bytes, words: str) -> str:
    """Where a decoder stopped ("... (byte 12)"), as line and column."""
    digits = words.rpartition("(byte ")[2].rstrip(")")
    at = int(digits) if digits.isdecimal() else 0
    before = data[:at].splitlines() or [b""]
    return f"line {len(before)}, column {len(before[-1]) + 1}"


def _is_text(data: bytes) -> bool:
    try:
        data.decode()
    except UnicodeDecodeError as error:
        return error.start >= len(data) - 3  # a letter cut in two at the end of what was read
    return True
