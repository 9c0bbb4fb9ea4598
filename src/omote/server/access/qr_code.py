"""Draws an address as a QR code: for a terminal, and as a picture for a page."""

from __future__ import annotations

import io

import segno

QUIET = 2
"""Light modules around the code: the standard asks for four, cameras need two."""
BLOCKS = {(True, True): "█", (True, False): "▀", (False, True): "▄", (False, False): " "}
BLACK_ON_WHITE = "\x1b[30;107m"
LIGHT = "\x1b[107m"
DARK = "\x1b[40m"
NORMAL = "\x1b[0m"


def draw_qr_code(text: str, *, encoding: str = "utf-8", colour: bool = False) -> str:
    """The lines of a QR code for a terminal.

    encoding: of the terminal; where it has no blocks, two characters make a module. colour: whether it takes colours
    (ANSI); without, a dark terminal is assumed and light modules are drawn. text: what it says.
    """
    rows = [[bool(module) for module in row] for row in segno.make(text, error="l").matrix_iter(border=QUIET)]
    if _has_blocks(encoding):
        return _draw_blocks(rows, colour=colour)
    if colour:
        light = [[(DARK if dark else LIGHT) + "  " for dark in row] for row in rows]
        return "\n".join("".join(row) + NORMAL for row in light)
    return "\n".join("".join("  " if dark else "##" for dark in row) for row in rows)


def qr_picture(text: str) -> str:
    """A QR code as an SVG picture, in an address that a page can show (`data:`)."""
    return segno.make(text, error="m").svg_data_uri(scale=6, border=4, light="#fff")


def draw_svg(text: str) -> bytes:
    """A QR code as an SVG picture."""
    drawn = io.BytesIO()
    segno.make(text, error="m").save(drawn, kind="svg", scale=6, border=4, light="#fff")
    return drawn.getvalue()


def _draw_blocks(rows: list[list[bool]], *, colour: bool) -> str:
    """Two modules in each character, one above the other."""
    rest = [[False] * len(rows[0])] if len(rows) % 2 else []
    pairs = zip(rows[::2], (rows + rest)[1::2], strict=True)
    drawn = (
        "".join(BLOCKS[(a, b) if colour else (not a, not b)] for a, b in zip(*pair, strict=True)) for pair in pairs
    )
    return "\n".join(f"{BLACK_ON_WHITE}{line}{NORMAL}" if colour else line for line in drawn)


def _has_blocks(encoding: str) -> bool:
    try:
        "".join(BLOCKS.values()).encode(encoding)
    except (UnicodeEncodeError, LookupError):
        return False
    return True
