"""Sounds that the show file keeps: sent with a name, heard after a restart, gone with their bytes."""

from __future__ import annotations

from pathlib import Path

import msgspec
import pytest
from typer.testing import CliRunner

from omote.cli import app
from omote.client.sounds import upload_sound
from omote.edit.store.whole_items import merge_show
from omote.model.cast import Cast
from omote.server.persistence.forget_face import forget_faces
from omote.server.sounds import sound_routes
from omote.show.access.people_list import Visitor
from omote.show.cues.cue_book import CueBook
from omote.show.objects.speech import Say
from omote.showfile.inspection import inspect_show
from omote.showfile.show_file import open_show
from tests.inputs.sounds.test_sound_file import wav
from tests.server.conftest import EditHarness, open_edit_harness


async def heard(house: EditHarness) -> tuple[str, bytes]:
    """What is said with the sound `line 1`: its key, and its bytes as a stage gets them."""
    session = house.show.session
    session.join("program", "Program")
    answers = session.receive("program", Say("one", f"say {house.clock.now}", "Hello", sound="line 1"), house.clock())
    assert answers == []
    house.tick()
    speech = session.tick(house.clock()).characters["one"].speech
    key = "" if speech is None else speech.sound
    return key, await (await house.client.get(f"/sounds/{key}")).read()


@pytest.mark.asyncio
async def test_a_sound_with_a_name_is_heard_after_a_restart_and_one_without_is_not_kept(
    cast: Cast, tmp_path: Path
) -> None:
    path = tmp_path / "show.omote"
    async with open_edit_harness(cast, path) as house:
        sent = await (await house.client.post("/sounds", params={"name": "line  1"}, data=wav(1.5))).json()
        assert (sent["name"], sent["seconds"]) == ("line 1", 1.5)
        await house.client.post("/sounds", data=wav(0.5))
        assert await heard(house) == (sent["sound"], wav(1.5))
        assert house.said == []
    stored = inspect_show(path)
    assert [*stored.stored.documents["sound"]] == ["line 1"]
    assert [*stored.contents.values()] == [wav(1.5)]
    async with open_edit_harness(cast, path) as house:
        assert await heard(house) == (sent["sound"], wav(1.5))
        assert house.said == []


@pytest.mark.asyncio
async def test_a_sound_that_is_deleted_leaves_the_file_with_its_bytes_and_comes_back_with_them(
    cast: Cast, tmp_path: Path
) -> None:
    path = tmp_path / "show.omote"
    async with open_edit_harness(cast, path) as house:
        named = house.show.session.named_sounds
        for name in ("line 1", "again"):  # the same bytes
            await house.client.post("/sounds", params={"name": name}, data=wav(1.5))
        house.tick()
        named.drop("again", {}, CueBook())
        house.tick()
        key, data = await heard(house)
        assert data == wav(1.5)
        named.drop("line 1", {}, CueBook())
        house.tick()
        assert (await house.client.get(f"/sounds/{key}")).status == 404
    gone = inspect_show(path)
    assert (gone.stored.documents, dict(gone.contents)) == ({}, {})
    async with open_edit_harness(cast, path) as house:
        named = house.show.session.named_sounds
        await house.client.post("/sounds", params={"name": "line 1"}, data=wav(1.5))
        house.tick()
        named.drop("line 1", {}, CueBook())
        house.tick()
        named.restore("line 1")
        house.tick()
    async with open_edit_harness(cast, path) as house:
        assert await heard(house) == (key, wav(1.5))


@pytest.mark.asyncio
async def test_a_new_take_replaces_the_one_before_where_that_is_asked_for(edit_harness: EditHarness) -> None:
    client = edit_harness.client
    await client.post("/sounds", params={"name": "line 1"}, data=wav(1.5))
    refused = await client.post("/sounds", params={"name": "line 1"}, data=wav(2.0))
    assert (refused.status, "or replace it" in await refused.text()) == (400, True)
    assert (await heard(edit_harness))[1] == wav(1.5)
    await client.post("/sounds", params={"name": "line 1", "replace": "1"}, data=wav(2.0))
    edit_harness.clock.now += 1.0
    assert (await heard(edit_harness))[1] == wav(2.0)


@pytest.mark.asyncio
async def test_only_those_who_may_edit_give_a_name(edit_harness: EditHarness, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sound_routes, "visitor_in", lambda _: Visitor("operate", "Ana"))
    refused = await edit_harness.client.post("/sounds", params={"name": "line 1"}, data=wav(1.5))
    assert (refused.status, 'the role "edit"' in await refused.text()) == (403, True)
    assert (await edit_harness.client.post("/sounds", data=wav(1.5))).status == 200


@pytest.mark.asyncio
async def test_a_program_adds_a_sound_and_speaks_with_it_by_its_name(edit_harness: EditHarness) -> None:
    address = str(edit_harness.client.make_url("/")).rstrip("/")
    key = await upload_sound(address, wav(1.5), headers={}, trusted=True, timeout=30.0, name="line 1")
    assert (await heard(edit_harness))[0] == key
    with pytest.raises(ValueError, match="there is a sound 'line 1' already"):
        await upload_sound(address, wav(2.0), headers={}, trusted=True, timeout=30.0, name="line 1")


@pytest.mark.asyncio
async def test_a_sound_goes_into_another_show_with_its_bytes_and_is_forgotten_for_good(
    cast: Cast, tmp_path: Path
) -> None:
    paths = [tmp_path / "a.omote", tmp_path / "b.omote"]
    async with open_edit_harness(cast, paths[0]) as house:
        await house.client.post("/sounds", params={"name": "line 1"}, data=wav(1.5))
        house.tick()
    there = inspect_show(paths[0])
    show = open_show(paths[1])
    show.apply(merge_show(cast, show.stored(), there.stored, there.contents).changes)
    show.close()
    async with open_edit_harness(cast, paths[1]) as house:
        assert (await heard(house))[1] == wav(1.5)
    listed = CliRunner().invoke(app, ["file", "list", str(paths[1]), "--documents", "sound", "--json"])
    assert msgspec.json.decode(listed.stdout)[0]["bytes"] > len(wav(1.5))
    assert wav(1.5)[:44] in paths[1].read_bytes()
    assert forget_faces(paths[1], ["line 1"]).labels == ("line 1",)
    assert not any(wav(1.5)[:44] in path.read_bytes() for path in tmp_path.glob("b.omote*"))
    assert inspect_show(paths[1]).stored.documents == {}
