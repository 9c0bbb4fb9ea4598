"""The portraits that come with the pages are those of the cast: else draw them anew."""

import json
import math
from pathlib import Path

from PIL import Image

import omote
from tools.pictures.portraits import COLUMNS, HEIGHT, NAMES, WIDTH, name_portraits


def test_the_sheet_holds_every_face_and_expression_of_the_cast() -> None:
    names = [tuple(each) for each in json.loads(NAMES.read_text())]
    assert names == name_portraits(omote.load_cast()), "run: python -m tools.pictures.portraits"
    with Image.open(Path(NAMES).with_suffix(".jpg")) as sheet:
        rows = math.ceil(len(names) / COLUMNS)
        assert sheet.size == (COLUMNS * (WIDTH + 1) - 1, rows * (HEIGHT + 1) - 1)
