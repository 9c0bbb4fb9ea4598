"""A code for a terminal is the code, module for module, in every way that it is drawn."""

import pytest
import segno

from omote.server.access.qr_code import DARK, NORMAL, QUIET, draw_qr_code, draw_svg, qr_picture

ADDRESS = "http://192.168.178.123:8090/console?token=" + "aZ_-" * 7


def modules() -> list[list[bool]]:
    return [[bool(each) for each in row] for row in segno.make(ADDRESS, error="l").matrix_iter(border=QUIET)]


def halves(text: str, *, dark: bool) -> list[list[bool]]:
    """The modules that lines of half blocks show; dark: whether a block is a dark module."""
    rows = []
    for line in text.splitlines():
        rows.append([(each in "█▀") == dark for each in line])
        rows.append([(each in "█▄") == dark for each in line])
    return rows[: len(modules())]


def test_half_blocks_show_the_code_black_on_white_where_there_are_colours() -> None:
    drawn = draw_qr_code(ADDRESS, colour=True)
    assert all(line.startswith("\x1b[30;107m") and line.endswith(NORMAL) for line in drawn.splitlines())
    plain = "\n".join(line.removeprefix("\x1b[30;107m").removesuffix(NORMAL) for line in drawn.splitlines())
    assert halves(plain, dark=True) == modules()
    assert max(map(len, plain.splitlines())) <= 60


def test_without_colours_light_modules_are_drawn_for_a_dark_terminal() -> None:
    assert halves(draw_qr_code(ADDRESS), dark=False) == modules()


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "no-such-encoding"])
def test_a_terminal_without_blocks_shows_two_characters_a_module(encoding: str) -> None:
    drawn = draw_qr_code(ADDRESS, encoding=encoding)
    assert drawn.isascii()
    found = [[line[i : i + 2] == "  " for i in range(0, len(line), 2)] for line in drawn.splitlines()]
    assert found == modules()
    coloured = draw_qr_code(ADDRESS, encoding=encoding, colour=True)
    assert coloured.count(DARK) == sum(map(sum, modules()))


def test_a_page_gets_a_picture() -> None:
    assert qr_picture(ADDRESS).startswith("data:image/svg+xml")


def test_a_file_holds_a_picture() -> None:
    assert b"<svg" in draw_svg(ADDRESS)
