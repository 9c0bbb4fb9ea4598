"""What a restarted server needs of a session, and how what older versions wrote becomes it."""

from __future__ import annotations

from typing import Any

import msgspec

from omote.perform.scene.character_names import FIRST_CHARACTER
from omote.perform.scene.scene import FIRST_LABEL
from omote.perform.scene.scene_snapshot import SceneSnapshot
from omote.perform.snapshot import limit_gaze
from omote.show.cues.cue_lists import CuesSnapshot
from omote.show.executed_calls import Executed
from omote.show.objects.show_notes import ShowNotes
from omote.show.ownership.leasing import LeaseSnapshot
from omote.show.preview_bus import PreviewSnapshot
from omote.show.sources.sources_snapshot import SourcesSnapshot, SurfaceSubscription


class SessionSnapshot(msgspec.Struct, frozen=True):
    """The scene, the ids of messages already executed, who holds what, the routes and measures of sources, the notes of
    the crew, how far its lists of cues are, which surfaces are told what is on air, and the preview where it has a look
    of its own."""

    scene: SceneSnapshot
    executed: Executed
    leases: LeaseSnapshot = LeaseSnapshot()
    sources: SourcesSnapshot = SourcesSnapshot()
    notes: ShowNotes = ShowNotes()
    cues: CuesSnapshot = CuesSnapshot()
    surfaces: tuple[SurfaceSubscription, ...] = ()
    preview: PreviewSnapshot | None = None


def read_session_snapshot(saved: object) -> tuple[SessionSnapshot, bool]:
    """The snapshot of plain values, whichever version wrote them; whether a gaze of an older one was beyond its range.

    ValueError and TypeError where it is none.
    """
    limited = limit_gaze(saved.get("performer")) if isinstance(saved, dict) else False
    return msgspec.convert(_as_today(saved), SessionSnapshot), limited


def _as_today(saved: object) -> object:
    """What older versions wrote, as it is written today.

    Up to protocol 4 a performer alone was written, who becomes the first character of a scene. Up to protocol 7 the
    ids of messages had no seat: they are of a show that has been closed, and nobody repeats one.
    """
    if not isinstance(saved, dict):
        return saved
    today = {key: value for key, value in saved.items() if key not in ("performer", "calls")}
    if "calls" in saved:
        today["executed"] = {}
    performer = saved.get("performer")
    if isinstance(performer, dict):
        standing = {"label": FIRST_LABEL}
        scene: dict[str, Any] = {"characters": {FIRST_CHARACTER: {"performer": performer, "standing": standing}}}
        today["scene"] = scene | {key: performer[key] for key in ("light", "time") if key in performer}
    return today
