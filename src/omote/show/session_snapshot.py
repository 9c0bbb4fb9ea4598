"""What a restarted server needs of a session, and how what older versions wrote becomes it."""

from __future__ import annotations

from typing import Any

import msgspec

from omote.perform.scene.character_names import FIRST_CHARACTER
from omote.perform.scene.scene import FIRST_LABEL
from omote.perform.scene.scene_snapshot import SceneSnapshot
from omote.perform.snapshot import limit_gaze
from omote.show.leases.leasing import LeaseSnapshot
from omote.show.sources.sources_snapshot import SourcesSnapshot


class SessionSnapshot(msgspec.Struct, frozen=True):
    """The scene, the calls already executed, who holds what, and the routes and measures of sources."""

    scene: SceneSnapshot
    calls: list[str]
    leases: LeaseSnapshot = LeaseSnapshot()
    sources: SourcesSnapshot = SourcesSnapshot()


def read_session_snapshot(saved: object) -> tuple[SessionSnapshot, bool]:
    """The snapshot of plain values, whichever version wrote them; whether a gaze of an older one was beyond its range.

    ValueError and TypeError where it is none.
    """
    limited = limit_gaze(saved.get("performer")) if isinstance(saved, dict) else False
    return msgspec.convert(_with_scene(saved), SessionSnapshot), limited


def _with_scene(saved: object) -> object:
    """The same where a performer alone was written, as up to protocol 4: it becomes the first character of a scene."""
    performer = saved.get("performer") if isinstance(saved, dict) else None
    if not isinstance(saved, dict) or not isinstance(performer, dict):
        return saved
    standing = {"label": FIRST_LABEL}
    scene: dict[str, Any] = {"characters": {FIRST_CHARACTER: {"performer": performer, "standing": standing}}}
    scene |= {key: performer[key] for key in ("light", "time") if key in performer}
    return {"scene": scene, "calls": saved.get("calls")}
