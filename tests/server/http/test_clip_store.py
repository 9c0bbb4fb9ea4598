"""The show file follows the clips of a session, in the order of their edits."""

from __future__ import annotations

import asyncio
from collections.abc import Sequence

from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.server.http.clip_store import Change, ClipStore, pack_changes
from omote.show.objects.clips import stored_clip
from omote.show.session import ShowSession
from omote.showfile.changes import DocumentRemoval, StoredDocument
from tests.perform.clips.curves import curve


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
