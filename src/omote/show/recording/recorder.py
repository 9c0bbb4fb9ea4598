"""Notes what a session does, so that a replay does it again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import msgspec

from omote.show.declaration import ClientMessage
from omote.show.ownership.leasing import LeaseSnapshot
from omote.show.recording.entries import (
    AnyEntry,
    ChannelsSet,
    Client,
    ClipsEdited,
    CuesEdited,
    Joined,
    Left,
    LineRejected,
    PreviewSet,
    Recast,
    Routed,
    Sent,
    SnapshotTaken,
    SoundsKnown,
    Ticked,
)
from omote.show.session import ShowSession, Unrecorded
from omote.show.sources.sources_snapshot import Route

SNAPSHOT_SECONDS = 2.0
"""Between two snapshots: a seek replays the ticks from the one before, which takes about as long as they took."""
PIECE_SNAPSHOTS = 30
"""Of a piece, which begins with one that has the cues too, and so needs no entry before it: a minute."""


class Recorder(Unrecorded):
    """The entries of a session from now on, until somebody takes them: once a tick. session: the show."""

    records = True

    def __init__(self, session: ShowSession) -> None:
        self._session = session
        self._entries: list[AnyEntry] = []
        self._known: dict[str, Client] = {}
        self._kept = 0
        self._kept_at: float | None = None
        self._tick: float | None = None
        session.recorder = self
        self._keep()

    def take(self, check: int | None = None) -> list[AnyEntry]:
        """Returns and clears what was noted.

        check: CRC-32 of the bytes of the last tick's state, as it was sent.
        """
        if self._tick is not None:
            now = self._tick
            self._end_tick(check)
            if self._kept_at is None or now - self._kept_at >= SNAPSHOT_SECONDS:
                self._kept_at = now
                self._keep()
        entries = self._entries
        self._entries = []
        return entries

    def note_message(self, who: str, message: ClientMessage, now: float) -> None:
        """Notes a message of a client (who) that was obeyed. now: seconds, monotonic."""
        if who:
            self._meet(who)
        if message.reads_preview:
            preview = self._session.preview
            self._note(PreviewSet(preview.scene().snapshot() if preview.is_there else None))
        self._note(Sent(who, now, message))

    def note_channels(self, who: str, character: str, values: Mapping[str, float], now: float) -> None:
        """Notes channels of a character that a client (who) has set. values: weights by channel; now: seconds,
        monotonic."""
        self._meet(who)
        self._note(ChannelsSet(who, now, character, dict(values)))

    def note_left(self, who: str) -> None:
        """Notes that a client (who) has left."""
        if self._known.pop(who, None) is not None:
            self._note(Left(who))

    def note_routed(self, source: str, route: Route) -> None:
        """Notes that a source has taken over. route: what it plays."""
        self._note(Routed(source, route))

    def note_sounds(self, seconds: Mapping[str, float], called: Mapping[str, str]) -> None:
        """Notes the sounds that there are, by their seconds. called: keys by name."""
        self._note(SoundsKnown(dict(seconds), dict(called)))

    def note_recast(self, digest: str) -> None:
        """Notes that another cast plays. digest: of the cast."""
        self._note(Recast(digest))

    def note_rejected(self, said: str) -> None:
        """Notes why (said) a line of a cue was not said."""
        self._note(LineRejected(said))

    def note_clips(self) -> None:
        """Notes the clips as an edit has left them."""
        self._note(ClipsEdited(dict(self._session.clips.clips)))

    def note_edit(self) -> None:
        """Notes the cues as an edit has left them: which cue stands by depends on each edit, not on the last alone."""
        cues = self._session.cues
        self._note(CuesEdited(cues.shown(), *cues.last_edit))

    def note_tick(self, now: float) -> None:
        """Notes a tick. now: seconds, monotonic."""
        self._end_tick(None)
        self._tick = now

    def _end_tick(self, check: int | None) -> None:
        if self._tick is not None:
            self._entries.append(Ticked(self._tick, check))
            self._tick = None

    def _note(self, entry: AnyEntry) -> None:
        self._end_tick(None)
        self._entries.append(entry)

    def _meet(self, who: str) -> None:
        member = self._session.members[who]
        called = Client(member.name, member.seat, member.bus)
        if self._known.get(who) != called:
            self._known[who] = called
            self._note(Joined(who, called))

    def _keep(self) -> None:
        """Notes the session as it is."""
        begins = self._kept % PIECE_SNAPSHOTS == 0
        self._kept += 1
        self._entries.append(snapshot_of(self._session, self._known, with_cues=begins))


def snapshot_of(session: ShowSession, members: Mapping[str, Client], *, with_cues: bool) -> SnapshotTaken:
    """The session as it is, for a replay to begin there. members: name and seat of those who have played, by client;
    with_cues: with the cues themselves."""
    snapshot = session.snapshot()
    cues = replace(snapshot.cues, states={})  # `playing` has them whole
    return SnapshotTaken(
        session=msgspec.structs.replace(snapshot, executed={}, leases=LeaseSnapshot(), cues=cues, preview=None),
        now=session.now,
        number=session.number,
        epoch=session.epoch,
        revision=session.revision,
        digest=session.cast.digest,
        members=dict(members),
        sources=session.sources.playing(),
        sounds=session.sounds.seconds(),
        sounds_called=session.sounds.called(),
        eyes=session.eye_offsets,
        playing=session.cues.playing(),
        book=session.cues.shown() if with_cues else None,
        clips=dict(session.clips.clips) if with_cues else None,
        runs=_runs_of(session),
    )


def _runs_of(session: ShowSession) -> dict[str, dict[int, Any]]:
    """The clips that play and were edited since, or dropped, by character and number of the run."""
    known = {id(clip) for clip in session.clips.clips.values()}
    playing = {name: session.scene[name].clips_playing() for name in session.scene}
    other = {
        name: {number: clip for number, clip in clips.items() if id(clip) not in known}
        for name, clips in playing.items()
    }
    return {name: clips for name, clips in other.items() if clips}
