"""Imports from pages: what a file brings is saved and plays, and one that brings nothing changes nothing."""

import sys
from pathlib import Path

import aiohttp
import msgspec
import pytest

from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Cast
from omote.server.http import uploads
from omote.server.http.uploads import Uploads, plan_upload
from omote.showfile.changes import Stored
from omote.showfile.show_file import open_show
from tests.server.conftest import EditHarness, ShowHarness

# Stands for `omote file import`: makes the changes that lie in the file.
IMPORTS = """
import sys
from pathlib import Path
import msgspec
from omote.showfile.changes import Change
from omote.showfile.show_file import open_show
copy, path = map(Path, sys.argv[-2:])
if path.read_bytes() == b"words":
    sys.exit(f"omote: {path.name} is no expression.")
show = open_show(copy)
show.apply(msgspec.msgpack.decode(path.read_bytes(), type=list[Change]))
show.close()
sys.stderr.write("omote: Grin, from grin.json" + chr(10) + "omote: the show file has 2 more." + chr(10))
"""


def letter(cast: Cast, stored: Stored) -> bytes:
    """A file that brings an expression and a face, both under labels that are there."""
    smile = ImportedItem("Smile", cast.expressions["smile"], ("mailed",))
    broad = ImportedItem("Broad", (cast.faces["broad"], cast.looks["broad"]))
    return msgspec.msgpack.encode(changes_to_import(cast, stored, [smile, broad], wall=1.0))


def stored_in(path: Path) -> Stored:
    file = open_show(path)
    try:
        return file.stored()
    finally:
        file.close()


async def post(harness: ShowHarness, file: str, data: bytes) -> tuple[int, str]:
    """What the show answers to a file."""
    async with harness.client.post(f"/imports/{file}", data=data) as response:
        return response.status, await response.text()


def use_fake_command(harness: EditHarness) -> None:
    harness.show.uploads = Uploads(lambda: harness.path, (sys.executable, "-c", IMPORTS))


@pytest.mark.asyncio
async def test_what_a_file_brings_is_in_the_file_and_plays_each_time_under_a_new_name(
    edit_harness: EditHarness, cast: Cast
) -> None:
    use_fake_command(edit_harness)
    for number in (1, 2):
        status, text = await post(edit_harness, "grin.json", letter(cast, stored_in(edit_harness.path)))
        assert (status, '"labels": ["Smile", "Broad"]' in text, "Grin, from grin.json" in text) == (200, True, True)
        assert edit_harness.show.session.revision == 1 + number, "pages are told of another cast"
    names = {"smile_2", "smile_3", "broad_2", "broad_3"}
    assert {own.name for own in edit_harness.show.documents.playing.own} == names
    stored = stored_in(edit_harness.path)
    assert {item.name for item in stored.items} == names
    assert len({item.id for item in stored.items}) == len({item.place for item in stored.items}) == 4
    page = await edit_harness.editor()
    assert page.greeted is not None
    assert {item.name for item in page.greeted.items} == names


@pytest.mark.asyncio
async def test_a_file_that_brings_nothing_is_told_and_changes_nothing(edit_harness: EditHarness) -> None:
    use_fake_command(edit_harness)
    assert await post(edit_harness, "notes.json", b"words") == (400, "notes.json is no expression.")
    status, text = await post(edit_harness, "notes.txt", b"words")
    assert (status, "is no expression that can be read" in text) == (400, True)
    assert edit_harness.show.session.revision == 1


@pytest.mark.asyncio
async def test_what_no_face_is_as_large_as_is_not_read(
    edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_fake_command(edit_harness)
    monkeypatch.setattr(uploads, "LARGEST", 10)
    status, text = await post(edit_harness, "big.glb", b"x" * 11)
    assert (status, "more than 10 bytes" in text) == (400, True)


@pytest.mark.asyncio
async def test_only_our_own_pages_may_send_files(edit_harness: EditHarness) -> None:
    use_fake_command(edit_harness)
    headers = {aiohttp.hdrs.ORIGIN: "http://elsewhere.example"}
    async with edit_harness.client.post("/imports/grin.json", data=b"words", headers=headers) as response:
        assert response.status == 403


@pytest.mark.asyncio
async def test_without_a_show_file_nothing_is_taken_in(show_harness: ShowHarness) -> None:
    status, text = await post(show_harness, "grin.json", b"words")
    assert (status, "no show file that can be written" in text) == (503, True)


def test_a_name_from_a_page_is_no_path() -> None:
    for sent in ("../../etc/grin.json", "/tmp/grin.json", "--grin.json", "\n.grin.json"):
        assert plan_upload(sent, "expression") == ("grin.json", "expression")


@pytest.mark.parametrize(
    ("file", "kind", "why"),
    [
        ("grin.json", "dog", "taken in as expression or face"),
        ("grin.json", "face", "expected a head"),
        ("grin", "expression", "is no expression that can be read"),
        ("grin.exe", "face", "is no face that can be read"),
        (".json", "expression", "is no expression that can be read"),
    ],
)
def test_what_nothing_can_be_made_of_is_refused_by_its_name(file: str, kind: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        plan_upload(file, kind)
