"""The sheets of the docs: what they ask for is there to be drawn."""

from __future__ import annotations

import re

import omote
from tools.pictures.contact_sheet import contact_sheets
from tools.pictures.drawing import PICTURES
from tools.pictures.gallery import gallery


def test_every_sheet_can_be_drawn_is_there_and_is_on_the_page_of_the_gallery() -> None:
    """Their poses were once written by a word that was renamed, and nobody drew them."""
    cast = omote.load_cast()
    sheets = gallery(cast)
    page = (PICTURES.parent / "gallery.md").read_text()
    assert sorted(re.findall(r"pictures/(gallery-[a-z]+)\.jpg", page)) == sorted(sheet.name for sheet in sheets)
    for sheet in (*sheets, *contact_sheets(cast)):
        assert (sheet.folder / f"{sheet.name}.jpg").is_file()
