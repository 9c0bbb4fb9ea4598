"""The show file follows the clips of a session, in the order of their edits."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from dataclasses import replace

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.server.http.clip_store import Change, ClipStore, pack_changes
from omote.show.objects.clips import CLIP_OUTLINE_PATH, ClipOutline, stored_clip
from omote.show.session import ShowSession
from omote.showfile.changes import DocumentRemoval, StoredDocument
from tests.perform.clips.curves import curve
from tests.server.conftest import ShowHarness


def test_edits_are_written_in_their_order_and_read_again(cast: Cast) -> None:
    session = ShowSession(cast)
    store = ClipStore(session)
    written: list[Change] = []

    async def edit() -> None:
        store.keep(written.extend)
        for seconds in (4.0, 0.5):
            session.clips.put("line1", Clip([Lane(curve(1, seconds=seconds))]))
            store.keep(written.extend)
        session.clips.put("other", Clip([Lane(curve(2))]))
        store.keep(written.extend)
        session.clips.load({})
        await asyncio.wait_for(store.settled(), 60.0)

    asyncio.run(edit())
    names = [(change.name, type(change)) for change in written]
    assert names == [("line1", StoredDocument)] * 2 + [("other", StoredDocument)]
    bodies = {change.name: change.body for change in written if isinstance(change, StoredDocument)}
    assert Clip([Lane(curve(1, seconds=0.5))]).seconds == 0.5
    told: list[str] = []
    store.load(lambda kind: {**bodies, "damaged": b"{}"} if kind == "clip" else {}, told.append)
    assert {name: stored_clip(clip).encode() for name, clip in session.clips.clips.items()} == bodies
    assert len(told) == 1
    assert pack_changes({"gone": None}) == [DocumentRemoval("clip", "gone")]


def write_nothing(_: Sequence[Change]) -> None:
    raise AssertionError("nothing was edited")


def test_a_show_whose_clips_stay_as_they_are_writes_nothing(cast: Cast) -> None:
    ClipStore(ShowSession(cast)).keep(write_nothing)


@pytest.mark.asyncio
async def test_pages_read_what_is_drawn_of_a_clip(show_harness: ShowHarness) -> None:
    clips = show_harness.show.session.clips
    lane = Lane(curve(1, seconds=2.0), name="mouth", parts=("mouth",), shift=0.5, muted=True)
    clips.put("line 1", replace(Clip([replace(lane, muted=False), lane]), start=0.25, loop=True))
    address = CLIP_OUTLINE_PATH.format(name="line 1")
    told = msgspec.json.decode(await (await show_harness.client.get(address)).read(), type=ClipOutline)
    assert (told.name, told.start, told.stop, told.trimmed, told.loop) == ("line 1", 0.25, lane.stop, False, True)
    assert [(each.name, each.muted, each.start, each.stop) for each in told.lanes] == [
        ("mouth", muted, lane.start, lane.stop) for muted in (False, True)
    ]
    assert told.lanes[0].moves
    assert told.edits == clips.work.edits
    assert (await show_harness.client.get(CLIP_OUTLINE_PATH.format(name="none"))).status == 204
