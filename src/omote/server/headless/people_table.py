"""Draws people in rows by expressions in columns: one picture of faces that no show file has to hold."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from omote.builtin import load_cast
from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.interchange.formats.atomic_file import write_whole
from omote.server.headless.picture_run import PictureProgress, PictureRun, PictureStudio, draw_run
from omote.showfile.changes import Content, Item, Revision, Stored
from omote.showfile.inspection import Inspection
from omote.showfile.schema import SCHEMA_VERSION
from omote.stage_data.picture_request import GridRequest


def hold_people(people: Sequence[ImportedItem], /) -> Inspection:
    """Faces as a show file would hold them, in memory alone; their names are those of its items, in their order."""
    changes = changes_to_import(load_cast(), Stored(), people, wall=0.0)
    items = tuple(change for change in changes if isinstance(change, Item))
    revisions = tuple(change for change in changes if isinstance(change, Revision))
    contents = {change.key: change.data for change in changes if isinstance(change, Content)}
    return Inspection(SCHEMA_VERSION, 0, Stored(items, revisions), contents)


def check_people(expressions: str, /) -> None:
    """Rejects, by ValueError, what people cannot wear, before anything is fitted or drawn."""
    PictureStudio().plan(_ask("generic", expressions), Path("people.png"))


def draw_people(path: Path, people: Sequence[ImportedItem], expressions: str, report: Callable[[int], None], /) -> None:
    """Draws people by expressions, names or mixes by commas, and writes the table alone: its single pictures and how
    they were drawn are not kept.

    report: told how many people are drawn. ValueError for an unknown expression; errors else as `draw_run`. path: of
    the picture; report: told how many people are drawn.
    """
    held = hold_people(people)
    studio = PictureStudio(held)
    names = ",".join(item.name for item in held.stored.items)

    def tell(done: PictureProgress) -> None:
        drawn, begun = divmod(done.number * len(people), done.total)
        if not begun:
            report(drawn)

    with TemporaryDirectory(prefix="omote-") as folder:
        drawn = Path(folder) / "people.png"
        run = studio.plan(_ask(names, expressions), drawn)
        draw_run(studio, _call_rows(run, [item.label for item in held.stored.items]), tell)
        write_whole(path, drawn.read_bytes())


def _call_rows(run: PictureRun, labels: Sequence[str]) -> PictureRun:
    """A run whose table calls its rows so."""
    table = run.whole
    return replace(run, table=replace(table, sheet=replace(table.sheet, rows=labels)))


def _ask(faces: str, expressions: str) -> GridRequest:
    return GridRequest(faces=faces, expressions=expressions, quality="good")
