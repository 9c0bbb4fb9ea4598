"""The preview: what was built up unseen is taken on air, a cue is looked at, or all begins anew from what is on air."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, ClassVar

import msgspec

from omote.perform.easing import DEFAULT_EASING
from omote.perform.scene.two_scenes import differing_parts, take_parts
from omote.show.declaration import CallId, ClientMessage, Name, Outgoing, Seconds, Session
from omote.show.objects.cues import MOST_RECORDED, CueNumber, ListName
from omote.show.objects.link import Refused
from omote.show.osc import PRESS, osc


class PreviewCommand(ClientMessage, frozen=True):
    """What is done with the preview as a whole, by whoever looks at either bus."""

    access = "operate"
    method: ClassVar[str | None] = ""


class Take(PreviewCommand, frozen=True):
    """Brings on air, in `seconds` and from whatever shows, each part that goes otherwise in preview: afterwards both
    look the same. What eyes look at and how much of layers shows is set at once; gestures and speech are no part of it.
    `parts`: only these (`one/face`, `one` for all of a character). Where others hold one of them, it is rejected whole;
    it holds none of them afterwards. An `id` executes once, as of those below."""

    reads_preview = True
    osc = (osc("take", "brings what preview has on air", "seconds", of_show=True),)

    id: CallId
    seconds: Seconds = 1.0
    easing: Name = DEFAULT_EASING
    parts: Annotated[list[Name], msgspec.Meta(max_length=MOST_RECORDED)] = []

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Calls what differs. session: the show; who: the client; now: seconds, monotonic."""
        unseen = session.preview.scene()
        parts = differing_parts(unseen, session.scene, self.parts)
        session.leasing.check_parts(who, parts)
        take_parts(unseen, session.scene, parts, seconds=self.seconds, easing=self.easing)
        return ()


class ResetPreview(PreviewCommand, frozen=True):
    """The preview is what is on air now; what was built up there is forgotten."""

    recorded = False
    osc = (osc("reset_preview", "makes preview what is on air now", PRESS, of_show=True),)

    id: CallId

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Begins it anew. session: the show; who: the client; now: seconds, monotonic."""
        session.preview.forget()
        return ()


class PreviewCue(PreviewCommand, frozen=True):
    """Shows a cue in preview as it will stand, with all that the cues before it leave: `update_cue` of somebody who
    looks at the preview then writes what is changed there into it, whatever runs on air. `run`: the cue's own moves go
    in their times. What was built up in preview is forgotten; what no cue of the list moves is as it goes on air.
    `cue_list`: as of `go`."""

    recorded = False
    osc = (
        osc("preview_cue", "shows a cue in preview, as it will stand", "cue", of_show=True),
        osc("preview_cue/run", "the same, with the cue's moves in their times", "cue", of_show=True, run=True),
    )

    id: CallId
    cue: CueNumber
    run: bool = False
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Shows it. session: the show; who: the client; now: seconds, monotonic."""
        name, cues, cue = session.cues.find(self.cue_list, self.cue)
        lost = session.preview.look_at(name, cues, cue, run=self.run)
        said = f"cue {cue.number} is in preview, but for what cannot be called: {'; '.join(lost)}."
        return [Outgoing(who, Refused(said, self.id))] if lost else []
