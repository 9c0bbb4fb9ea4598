"""Editors on a real socket, show file and order runner: what is acknowledged is stored and plays."""

import sqlite3
from pathlib import Path
from typing import Any
from urllib.parse import quote

import msgspec
import numpy as np
import pytest
from aiohttp import WSMsgType
from numpy.typing import NDArray

from omote.edit.protocol import messages as editing
from omote.edit.protocol.messages import EDITING_LIMIT, EDITING_PATH
from omote.edit.protocol.wire import decode_answer
from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments
from omote.server.persistence import restore
from omote.server.workers.workshop import RefusedOrderError
from omote.show.cast_documents import CompoundAsset, ContentAsset, Manifest
from omote.show.declaration import ClientMessage
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.items import DeleteItem, ItemChanged, KeepExpression, KeepFace, Kept, RestoreItem
from omote.show.objects.layouts import DropLayout, Layout, Layouts, RenameLayout, SetLayout
from omote.show.objects.link import Bus, Notice, Notices, Ping, Pong, Refused
from omote.show.objects.stages import CastChanged
from omote.show.objects.state import State
from omote.show.wire import encode
from omote.showfile.changes import Change, Revision
from omote.showfile.show_file import ShowFile, open_show
from omote.stage_data.assets import rest_positions
from tests.compound_assets import unpack_compound
from tests.server.conftest import EditHarness, Editor, ShowHarness, answer, open_edit_harness, send_and_wait, state

pytestmark = pytest.mark.asyncio

Points = NDArray[np.floating[Any]]


async def manifest(show_harness: ShowHarness) -> Manifest:
    """The manifest as it is now."""
    response = await show_harness.client.get("/manifest")
    return msgspec.msgpack.decode(await response.read(), type=Manifest)


async def shown(show_harness: EditHarness, cast: Cast, face: str, content: str) -> Points:
    """A built-in face wearing a content, as pages get it."""
    path = f"/compounds/{cast.digest}/{quote(face, safe='')}/{quote(content, safe='')}"
    response = await show_harness.client.get(path)
    assert response.status == 200, await response.text()
    rest = rest_positions(cast, cast.faces[face])
    moves: Points = unpack_compound(msgspec.msgpack.decode(await response.read(), type=CompoundAsset), len(rest))
    worn: Points = rest + moves
    return worn


async def saved(page: Editor, label: str = "Grin") -> Any:
    """An own expression that plays."""
    draft = await page.ask(editing.CreateExpression, label, {"smile": 1.0}, False)
    assert isinstance(await page.ask(editing.Save, draft.item, ""), editing.Saved)
    return draft


async def test_a_dragged_point_lies_where_it_was_put_and_plays_once_it_is_saved(
    edit_harness: EditHarness, cast: Cast
) -> None:
    page = await edit_harness.editor()
    console = await edit_harness.link()
    draft = await page.ask(editing.CreateExpression, "Crooked smile", {"smile": 0.5}, False)
    place = 20
    row = draft.recipe.net[20]
    target = (await shown(edit_harness, cast, "long", draft.content))[row] + [0.001, 0.002, 0.0]
    moved = await page.ask(
        editing.DragPoints, draft.item, "long", [place], [tuple(target.tolist())], list(draft.recipe.vectors)
    )
    assert moved.miss < 5e-5
    assert np.linalg.norm((await shown(edit_harness, cast, "long", moved.content))[row] - target) < 5e-5
    assert (await manifest(edit_harness)).digest == cast.digest
    done = await page.ask(editing.Save, draft.item, "first")
    assert (done.revision, done.aside) == (1, False)
    changed = await answer(console)
    assert isinstance(changed, CastChanged)
    now = await manifest(edit_harness)
    assert (now.base, now.digest) == (cast.digest, changed.digest)
    own = now.expressions[-1]
    assert (own.name, own.label, own.kind, own.source) == ("crooked_smile", "Crooked smile", "own", moved.content)
    await send_and_wait(console, CallExpression("one", "1", own.name, 0.0, "smooth"))
    edit_harness.tick()
    seen = await state(console)
    assert (seen.characters["one"].expressions, seen.revision) == ({own.name: 1.0}, changed.revision)


async def test_what_is_acknowledged_is_in_the_file(edit_harness: EditHarness) -> None:
    page = await edit_harness.editor()
    draft = await saved(page)
    file = open_show(edit_harness.path)
    stored = file.stored()
    contents = file.contents()
    file.close()
    assert [(item.label, item.head) for item in stored.items] == [("Grin", 1)]
    assert stored.revisions[0].content == draft.content.removeprefix("#")
    assert stored.revisions[0].content in contents


async def test_a_show_that_starts_again_has_own_things_on_air(
    cast: Cast, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(restore, "FIRST_LIVELINESS", 0.0)
    path = tmp_path / "a.omote"
    async with open_edit_harness(cast, path) as first:
        page = await first.editor()
        console = await first.link()
        await saved(page)
        face = await page.ask(editing.CreateFace, "Cousin", {"broad": 0.5, "long": 0.5}, False)
        await page.ask(editing.Save, face.item, "")
        await wait_until_obeyed(console, CallFace("one", "1", "cousin", 0.0, "smooth"), SetChannel("one", "grin", 0.5))
        first.tick()
        digest = (await manifest(first)).digest
    async with open_edit_harness(cast, path) as second:
        console = await second.link()
        second.tick()
        seen = await state(console)
        assert (seen.characters["one"].faces, seen.characters["one"].channels) == ({"cousin": 1.0}, {"grin": 0.5})
        assert (await manifest(second)).digest == digest
        assert second.said == []


async def wait_until_obeyed(console: Any, *messages: ClientMessage) -> None:
    """Sends messages and waits until the server has heard them all, whatever it says before."""
    for message in (*messages, Ping(1.0)):
        await console.send_bytes(encode(message))
    while not isinstance(said := await answer(console), Pong):
        assert isinstance(said, CastChanged | State)


async def test_an_own_face_is_served_by_its_content_and_is_in_the_cast_once_saved(
    edit_harness: EditHarness, cast: Cast
) -> None:
    page = await edit_harness.editor()
    draft = await page.ask(editing.CreateFace, "Cousin", {"broad": 0.5, "long": 0.5}, False)
    key = draft.content.removeprefix("#")
    asset = msgspec.msgpack.decode(await (await edit_harness.client.get(f"/contents/{key}")).read(), type=ContentAsset)
    points = np.frombuffer(asset.positions, "<f4").reshape(-1, 3)[: cast.space.vertex_count]
    both = (cast.faces["broad"].positions + cast.faces["long"].positions) / 2
    assert np.abs(points - both).max() < 1e-4
    await page.ask(editing.Save, draft.item, "")
    face = (await manifest(edit_harness)).faces[-1]
    assert (face.name, face.label, face.source, face.url) == ("cousin", "Cousin", draft.content, f"/contents/{key}")
    assert face.extremes == asset.face.extremes
    response = await edit_harness.client.get(f"/compounds/{cast.digest}/{quote(draft.content, safe='')}/smile")
    assert response.status == 200


@pytest.mark.parametrize("bus", ["air", "preview"])
async def test_a_console_keeps_what_it_sees(edit_harness: EditHarness, cast: Cast, bus: Bus) -> None:
    console = await edit_harness.link(bus=bus)
    await send_and_wait(console, CallFace("one", "1", "broad", 2.0, "smooth"), SetChannel("one", "jawOpen", 0.25))
    for _ in range(60):
        edit_harness.tick()
    await console.send_bytes(encode(KeepFace("one", "k")))
    await console.send_bytes(encode(KeepFace("one", "k")))  # a bouncing key
    await console.send_bytes(encode(KeepExpression("one", "l")))
    kept: list[Kept] = []
    while len(kept) < 2:
        said = await answer(console)
        kept += [said] if isinstance(said, Kept) else []
    assert [each.id for each in kept] == ["k", "l"]
    now = await manifest(edit_harness)
    content = await (await edit_harness.client.get(now.faces[-1].url)).read()
    asset = msgspec.msgpack.decode(content, type=ContentAsset)
    points = np.frombuffer(asset.positions, "<f4").reshape(-1, 3)[: cast.space.vertex_count]
    generic, broad = (cast.faces[name].positions for name in ("generic", "broad"))
    assert (
        np.abs(points - (generic + broad) / 2).max() < 0.05 * np.abs(broad - generic).max()
    )  # half of the call's time
    assert [now.faces[-1].name, now.expressions[-1].name] == [each.name for each in kept]
    assert [now.faces[-1].label, now.expressions[-1].label] == [each.label for each in kept]
    for number, (asked, shown) in enumerate(((DeleteItem, False), (RestoreItem, True))):
        await console.send_bytes(encode(asked(f"m{number}", "face", kept[0].name)))
        said = await answer(console)
        while not isinstance(said, ItemChanged):
            said = await answer(console)
        assert said == ItemChanged(f"m{number}", kept[0].label, kept[0].label)
        assert (kept[0].name in [face.name for face in (await manifest(edit_harness)).faces]) is shown
    await console.send_bytes(encode(DeleteItem("n", "face", "nobody")))
    while not isinstance(said, Refused):
        said = await answer(console)
    assert said.id == "n"


async def test_two_editors_hear_of_each_other_and_the_second_is_told(edit_harness: EditHarness) -> None:
    ada = await edit_harness.editor("a", "Ada")
    bea = await edit_harness.editor("b", "Bea")
    draft = await saved(ada)
    for page in (ada, bea):
        await page.ask(editing.OpenItem, draft.item)
        vectors = [(0.0, 0.001 if page is ada else 0.002, 1.0)] * len(draft.recipe.net)
        await page.ask(editing.SetVectors, draft.item, vectors, "up")
    first = await ada.ask(editing.Save, draft.item, "")
    second = await bea.ask(editing.Save, draft.item, "")
    assert (first.revision, first.aside, second.revision, second.head, second.aside) == (2, False, 3, 2, True)
    assert "Ada saved" in second.sentence


async def test_what_the_worker_rejects_comes_back_as_a_message(
    edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = await edit_harness.editor()
    draft = await saved(page)

    async def refuse(self: CastDocuments, order: object) -> bytes:
        raise RefusedOrderError("the point cannot lie there: put it nearer")

    monkeypatch.setattr(CastDocuments, "run_order", refuse)
    vectors = [(0.0, 0.001, 1.0)] * len(draft.recipe.net)
    refused = await page.ask(editing.SetVectors, draft.item, vectors, "up")
    assert isinstance(refused, editing.EditRefused)
    assert "cannot lie there: put it nearer." in refused.reason


async def test_what_an_editor_says_wrong_is_refused_and_the_link_stays(edit_harness: EditHarness) -> None:
    page = await edit_harness.editor()
    await page.socket.send_str("save")
    assert "binary MessagePack" in (await page.next(editing.EditRefused)).reason  # type: ignore[union-attr]
    await page.socket.send_bytes(b"\xc1")
    refused = await page.next(editing.EditRefused)
    assert isinstance(refused, editing.EditRefused)
    assert refused.request == -1
    assert isinstance(await page.ask(editing.OpenItem, 99), editing.EditRefused)
    await page.socket.send_bytes(bytes(EDITING_LIMIT + 1))
    last = decode_answer(await page.socket.receive_bytes(timeout=60.0))
    assert isinstance(last, editing.EditRefused)
    assert f"longer than {EDITING_LIMIT} bytes" in last.reason


@pytest.mark.parametrize("origin", ["http://evil.example", "null"])
async def test_only_our_own_pages_may_edit(edit_harness: EditHarness, origin: str) -> None:
    response = await edit_harness.client.get(EDITING_PATH, headers={"Host": "localhost:8090", "Origin": origin})
    assert response.status == 403


async def test_without_a_file_an_editor_is_told_that_nothing_can_be_kept(show_harness: ShowHarness) -> None:
    assert (await show_harness.client.get("/layouts/desk")).status == 204
    console = await show_harness.link()
    await console.send_bytes(encode(KeepFace("one", "k")))
    said = await answer(console)
    assert isinstance(said, Refused)
    assert "no show file that can be written" in said.reason


async def test_an_editor_of_a_show_without_a_file_is_told(cast: Cast) -> None:
    async with open_edit_harness(cast, None) as edit_harness:
        page = Editor(await edit_harness.client.ws_connect(EDITING_PATH))
        await page.socket.send_bytes(encode(editing.Greet("a", "Ada", editing.EDITING_VERSION)))
        refused = await page.next(editing.EditRefused)
        assert isinstance(refused, editing.EditRefused)
        assert "no show file that can be written" in refused.reason
        console = await edit_harness.link()
        await console.send_bytes(encode(SetLayout("desk", LAYOUT)))
        assert isinstance(await answer(console), Refused)


LAYOUT = Layout(2, {"face": {"seconds": 2.0, "easing": "smooth"}}, "own", "brows", linked=True).encode().decode()


async def test_a_page_finds_its_layout_again_and_all_consoles_hear_which_there_are(edit_harness: EditHarness) -> None:
    console = await edit_harness.link()
    other = await edit_harness.link()
    for message, there in [
        (SetLayout("desk", LAYOUT), ["desk"]),
        (RenameLayout("desk", "left"), ["left"]),
        (SetLayout("right", LAYOUT), ["left", "right"]),
        (DropLayout("right"), ["left"]),
    ]:
        await console.send_bytes(encode(message))
        assert await answer(console) == await answer(other) == Layouts(there)
    await console.send_bytes(encode(SetLayout("desk 2", "{no JSON")))
    said = await answer(console)
    assert isinstance(said, Refused)
    assert "desk 2" in said.reason
    response = await edit_harness.client.get("/layouts/left")
    assert (response.content_type, await response.text()) == ("application/json", LAYOUT)
    assert (await edit_harness.client.get("/layouts/desk")).status == 204
    late = await edit_harness.link()
    assert await answer(late) == Layouts(["left"])


async def test_an_edit_that_the_file_refuses_is_undone_for_everybody(
    edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = await edit_harness.editor()
    draft = await saved(page)
    apply = ShowFile.apply

    def refuse(self: ShowFile, changes: tuple[Change, ...]) -> None:
        if any(isinstance(change, Revision) for change in changes):
            raise ValueError("no room")
        apply(self, changes)

    monkeypatch.setattr(ShowFile, "apply", refuse)
    vectors = [(0.0, 0.001, 1.0)] * len(draft.recipe.net)
    await page.ask(editing.SetVectors, draft.item, vectors, "up")
    await page.socket.send_bytes(encode(editing.Save(99, draft.item, "")))
    while (await page.socket.receive(timeout=60.0)).type is WSMsgType.BINARY:
        pass  # until the link is cut
    assert "no room" in edit_harness.said[0]
    monkeypatch.undo()
    again = await edit_harness.editor()
    assert again.greeted is not None
    assert [item.head for item in again.greeted.items] == [1]
    opened = await again.ask(editing.OpenItem, draft.item)
    assert (opened.dirty, opened.undo) == (True, 1)


async def test_while_the_disk_fails_editors_are_told_and_nothing_is_acknowledged(
    edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = await edit_harness.editor()
    draft = await saved(page)
    apply = ShowFile.apply
    left = [1]

    def fail_once(self: ShowFile, changes: tuple[Change, ...]) -> None:
        if left[0]:
            left[0] -= 1
            error = sqlite3.OperationalError("disk I/O error")
            error.sqlite_errorcode = sqlite3.SQLITE_IOERR
            raise error
        apply(self, changes)

    monkeypatch.setattr(ShowFile, "apply", fail_once)
    vectors = [(0.0, 0.001, 1.0)] * len(draft.recipe.net)
    page.heard.clear()
    state = await page.ask(editing.SetVectors, draft.item, vectors, "up")
    assert isinstance(state, editing.DraftState)
    told = [each for each in page.heard if isinstance(each, editing.EditRefused)]
    assert [each.request for each in told] == [-1]
    assert "show.omote cannot be written (the disk fails): your work is kept" in told[0].reason


async def test_what_was_called_since_the_last_tick_cannot_be_deleted(edit_harness: EditHarness) -> None:
    page = await edit_harness.editor()
    draft = await saved(page)
    console = await edit_harness.link()
    edit_harness.tick()
    await wait_until_obeyed(console, CallExpression("one", "1", "grin", 1.0, "smooth"))
    refused = await page.ask(editing.Delete, draft.item)
    assert isinstance(refused, editing.EditRefused)
    assert "is on air or coming" in refused.reason


async def test_editors_are_told_what_the_crew_must_know(edit_harness: EditHarness) -> None:
    early = await edit_harness.editor("a", "Ann")
    notices = [Notice("1", 1.7e9, "The show file was recovered.")]
    edit_harness.show.post(notices)
    assert await early.next(Notices) == Notices(notices)
    late = await edit_harness.editor("b", "Bob")
    assert await late.next(Notices) == Notices(notices)
