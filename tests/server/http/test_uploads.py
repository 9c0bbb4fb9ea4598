"""Imports from pages: what a file brings is saved and plays, and one that brings nothing changes nothing."""

import asyncio
import json
from pathlib import Path

import aiohttp
import msgspec
import pytest

from omote.edit.store.import_items import ImportedItem, changes_to_import
from omote.model.cast import Cast
from omote.server.http import uploads
from omote.server.http.uploads import CANCELLED, Uploads, plan_upload
from omote.server.workers.file_jobs import Imported, ImportFile, bring_items
from omote.server.workers.job_server import Follow, JobError
from omote.show.objects.link import Cancel, Progress
from omote.show.wire import encode
from omote.showfile.changes import Stored
from omote.showfile.show_file import open_show
from tests.server.conftest import EditHarness, ShowHarness, answer


async def import_false_file(job: bytes, follow: Follow) -> bytes:
    """Stands for `run_file_job` in its process: brings what lies in the file."""
    wanted = msgspec.msgpack.decode(job, type=ImportFile)
    data = Path(wanted.path).read_bytes()
    if data == b"words":
        raise JobError(f"{Path(wanted.path).name} is no expression.")
    follow(0, 2, "Smile")
    if data == b"endless":
        await asyncio.Event().wait()
    return data


def letter(cast: Cast, stored: Stored, expression: str = "smile", face: str = "broad") -> bytes:
    """What is brought: an expression and a face, both under labels that are there."""
    smile = ImportedItem("Smile", cast.expressions[expression], ("mailed",))
    broad = ImportedItem("Broad", (cast.faces[face], cast.looks[face]))
    changes = changes_to_import(cast, stored, [smile, broad], wall=1.0)
    return msgspec.msgpack.encode(Imported(list(bring_items(changes)), ["Grin, from grin.json"]))


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


def use_false_job(harness: EditHarness) -> None:
    harness.show.uploads = Uploads(lambda: harness.path, import_false_file, harness.show.long_requests)


@pytest.mark.asyncio
async def test_what_a_file_brings_is_in_the_file_and_plays_under_a_name_that_nothing_else_has(
    edit_harness: EditHarness, cast: Cast
) -> None:
    use_false_job(edit_harness)
    for number, (smile, broad) in enumerate([("smile", "broad"), ("jawOpen", "long")], start=1):
        status, text = await post(edit_harness, "grin.json", letter(cast, stored_in(edit_harness.path), smile, broad))
        assert (status, "Grin, from grin.json" in text) == (200, True)
        assert [(each["label"], each["known"]) for each in json.loads(text)["items"]] == [
            (f"Smile {1 + number}", False),
            (f"Broad {1 + number}", False),
        ]
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
async def test_what_is_there_already_is_told_and_not_taken_in_again(edit_harness: EditHarness, cast: Cast) -> None:
    use_false_job(edit_harness)
    for known in (False, True):
        _, text = await post(edit_harness, "grin.json", letter(cast, stored_in(edit_harness.path)))
        assert json.loads(text)["items"] == [
            {"kind": "expression", "name": "smile_2", "label": "Smile 2", "known": known},
            {"kind": "face", "name": "broad_2", "label": "Broad 2", "known": known},
        ]
        assert edit_harness.show.session.revision == 2, "nobody is told of a cast that is as it was"
    assert len(stored_in(edit_harness.path).items) == 2


@pytest.mark.asyncio
async def test_a_file_that_brings_nothing_is_told_and_changes_nothing(edit_harness: EditHarness) -> None:
    use_false_job(edit_harness)
    assert await post(edit_harness, "notes.json", b"words") == (400, "notes.json is no expression.")
    status, text = await post(edit_harness, "notes.txt", b"words")
    assert (status, "no shapes that could be expressions" in text) == (400, True)
    assert edit_harness.show.session.revision == 1


@pytest.mark.parametrize("page", ["console", "editor"])
@pytest.mark.asyncio
async def test_an_import_tells_its_progress_and_a_page_ends_it(edit_harness: EditHarness, page: str) -> None:
    use_false_job(edit_harness)
    console = await edit_harness.link()
    editor = await edit_harness.editor()
    sent = asyncio.create_task(post(edit_harness, "grin.json?request=mine", b"endless"))
    smiling = Progress("mine", 0, 2, "Smile")
    while await editor.next(Progress) != smiling:
        pass
    while await answer(console) != smiling:
        pass
    link = console if page == "console" else editor.socket
    await link.send_bytes(encode(Cancel("nobody's")))
    await link.send_bytes(encode(Cancel("mine")))
    assert await sent == (CANCELLED, "")
    assert not stored_in(edit_harness.path).items
    status, _ = await post(edit_harness, "grin.json?request=mine", letter(edit_harness.show.documents.cast, Stored()))
    assert status == 200, "and the next one is taken in"


@pytest.mark.asyncio
async def test_what_no_face_is_as_large_as_is_not_read(
    edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    use_false_job(edit_harness)
    monkeypatch.setattr(uploads, "LARGEST", 10)
    status, text = await post(edit_harness, "big.glb", b"x" * 11)
    assert (status, "more than 10 bytes" in text) == (400, True)


@pytest.mark.asyncio
async def test_only_our_own_pages_may_send_files(edit_harness: EditHarness) -> None:
    use_false_job(edit_harness)
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
        ("grin.json", "face", "a document of expressions; leave out --as face, or drop it on the list of expressions"),
        ("grin", "expression", "export it as one of .ply, .obj, .glb, .gltf, .vrm, .json"),
        ("grin.exe", "face", "cannot be taken in as a face: export it as one of"),
        (
            "head.xyz",
            "expression",
            "no shapes that could be expressions, and a face is made of it: omote face head.xyz",
        ),
        ("head.stl", "face", "a face is made of it: omote face head.stl"),
        ("anna.HEIC", "expression", "a photograph has no shape; drop it on the editor"),
        (".json", "expression", "cannot be taken in as an expression"),
        ("other.omote", "face", "`omote file import` takes all of it into another show file, which no show plays"),
    ],
)
def test_what_nothing_can_be_made_of_is_refused_by_its_name(file: str, kind: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        plan_upload(file, kind)
