"""Files of every schema that Omote has had open, are brought up, and hold what they held."""

import contextlib
import shutil
import sqlite3
from pathlib import Path

import pytest

from omote.showfile.changes import Draft, Edit, Item, Revision, Stored
from omote.showfile.inspection import inspect_show, verdicts
from omote.showfile.schema import AUTHORED_SINCE, SCHEMA_VERSION, CorruptShowFileError
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

GOLDEN = sorted((Path(__file__).parent / "golden").iterdir())
"""Made by the code of their time, in pages of 512 bytes; a new schema adds one, and none is ever changed."""
SMILE = "446512cb856d4d523a9b8c45"
ANN = "35de3f72bc53b90072a4bc7c"
START = b'{"kind":"expression","net":[1],"vectors":[[0.0,0.0,1.0]],"ground":null,'
END = b'"pulls":[],"eyes":[0.0,0.0,0.0,0.0],"pupil":0.0}'
LAYER = f'{{"source":"#{SMILE}","label":"Smile","weight":1.0,"region":null,"mirrored":false,"muted":false}}'
PLAIN = START + b'"layers":[],' + END
SMILING = START + f'"layers":[{LAYER}],'.encode() + END
FACE = b'{"kind":"face","base":{"generic":1.0},"regions":{},"amount":1.0,"points":[],"moves":[],"gains":[]}'
AUTHORED = Stored(
    items=(
        Item(1, "expression", "smile", "Smile", ("wry", "left"), 1.5, 2),
        Item(2, "face", "ann", "Ann", (), 2, 1, True),
    ),
    revisions=(
        Revision(1, 1, 0, PLAIN, SMILE, 1.75e9, "Ada", "first"),
        Revision(1, 2, 1, SMILING, SMILE, 1.75e9 + 60, "Bo"),
        Revision(1, 3, 1, PLAIN, SMILE, 1.75e9 + 90, "Ada", "beside", aside=True),
        Revision(2, 1, 0, FACE, ANN, 1.75e9, "import"),
    ),
    drafts=(Draft(1, "ada", 2, 1),),
    edits=(Edit(1, "ada", 0, SMILING, "opened"), Edit(1, "ada", 1, PLAIN, "layers")),
)
DOCUMENTS = {
    "layout": (2, {"Left": b'{"version":2,"kind":"own"}', "Rechts \xe4": b'{"version":1}'}),
    "bindings": (5, {"bindings": b'{"bindings":[],"presets":{"nanoKONTROL2":"nanokontrol2"}}'}),
    "performer": (6, {"Ada": b'{"calibration":{},"guided":true}', "Bo": b'{"calibration":{}}'}),
}
"""What each kind of document held, and the schema since which there is one."""


def expected(version: int) -> Stored:
    """The authored work in the golden file of a schema."""
    if version < AUTHORED_SINCE:
        return Stored()
    documents = {kind: named for kind, (since, named) in DOCUMENTS.items() if version >= since}
    return Stored(AUTHORED.items, AUTHORED.revisions, AUTHORED.drafts, AUTHORED.edits, documents)


def held(show: ShowFile) -> tuple[object, ...]:
    """All that a show file holds."""
    aside = show._connection.execute("SELECT epoch, reason, snapshot FROM journal_aside").fetchall()
    return show.stored(), sorted(show.contents()), show.journal(), aside


def test_there_is_a_golden_file_of_every_schema() -> None:
    assert [inspect_show(path).version for path in GOLDEN] == [*range(1, SCHEMA_VERSION + 1)]


@pytest.mark.parametrize("golden", GOLDEN, ids=lambda path: path.stem)
def test_a_file_of_any_schema_opens_is_brought_up_and_holds_the_same(tmp_path: Path, golden: Path) -> None:
    version = int(golden.stem.removeprefix("version_"))
    path = tmp_path / "a.omote"
    shutil.copyfile(golden, path)
    before = inspect_show(path)
    assert (before.version, before.epoch, before.stored) == (version, 1234, expected(version))
    for _ in range(2):
        show = open_show(path)
        contents = [ANN, SMILE] if version >= AUTHORED_SINCE else []
        entry = JournalEntry(1234, 5.5, b"\1\2")
        assert held(show) == (expected(version), contents, entry, [(1200, "it crashed", b"\3")])
        identity = show.identity()
        show.close()
    after = inspect_show(path)
    assert (after.version, after.stored, after.contents) == (SCHEMA_VERSION, before.stored, before.contents)
    assert [sentence for right, sentence in verdicts(path) if not right] == []
    again = open_show(path)
    assert again.identity() == identity
    again.close()


@pytest.mark.parametrize("table", ["layout", "binding_list", "performer"])
def test_a_document_of_before_that_is_damaged_is_not_brought_up(tmp_path: Path, table: str) -> None:
    path = tmp_path / "a.omote"
    shutil.copyfile(GOLDEN[6], path)
    with contextlib.closing(sqlite3.connect(path)) as connection, connection:
        connection.execute(f"UPDATE {table} SET document = x'00'")
    with pytest.raises(CorruptShowFileError, match=f"its {table} .* is damaged"):
        open_show(path)
    with contextlib.closing(sqlite3.connect(path)) as connection:
        assert connection.execute("PRAGMA user_version").fetchone() == (7,)
