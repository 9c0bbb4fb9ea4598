"""People by expressions: as a show file would hold them, drawn as `omote grid` draws, and nothing else is left."""

from collections.abc import Callable
from pathlib import Path

import pytest

from omote.builtin import load_cast
from omote.edit.store.import_items import ImportedItem
from omote.face_commands import EXPRESSIONS
from omote.server.headless import people_table
from omote.server.headless.people_table import draw_people, hold_people
from omote.server.headless.picture_run import PictureProgress, PictureRun, PictureStudio
from omote.showfile.contents import unpack_face
from omote.stage_data.full_cast import build_full_cast

CAST = load_cast()
PEOPLE = [ImportedItem(label, (CAST.faces[face], CAST.looks[face])) for label, face in (("Ann", "old"), ("Ann", "dog"))]


def test_people_are_held_as_a_show_file_holds_them_also_of_one_name() -> None:
    held = hold_people(PEOPLE)
    cast = build_full_cast(CAST, held.stored, held.contents, pytest.fail)
    names = [item.name for item in held.stored.items]
    assert len(set(names)) == len(PEOPLE)
    for name, person in zip(names, ("old", "dog"), strict=True):
        assert (cast.faces[name].positions == CAST.faces[person].positions).all()
        assert cast.looks[name] == CAST.looks[person]
    assert {unpack_face(data, "x")[0].positions.shape for data in held.contents.values()}


def test_a_table_is_written_alone_with_a_row_for_each_person_and_a_column_for_each_expression(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    planned: list[PictureRun] = []

    def draw(_: PictureStudio, run: PictureRun, report: Callable[[PictureProgress], None]) -> None:
        planned.append(run)
        for number in range(1, 1 + len(run.pictures)):
            report(PictureProgress(run.whole.path, 0.1, number, len(run.pictures)))
        run.whole.path.write_bytes(b"drawn")

    monkeypatch.setattr(people_table, "draw_run", draw)
    told: list[int] = []
    draw_people(tmp_path / "people.png", PEOPLE, EXPRESSIONS, told.append)
    assert told == [1, 2]
    assert (tmp_path / "people.png").read_bytes() == b"drawn"
    assert [path.name for path in tmp_path.iterdir()] == ["people.png"]
    (run,) = planned
    assert len(run.pictures) == len(PEOPLE) * len(EXPRESSIONS.split(","))
    assert [*run.whole.sheet.rows] == ["Ann", "Ann"], "people are called as the report calls them"
    with pytest.raises(ValueError, match="grin"):
        draw_people(tmp_path / "people.png", PEOPLE, "grin", told.append)
