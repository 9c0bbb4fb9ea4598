"""The clips of a session: what plays is called by name, what is edited is written after the tick, as cues are."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import msgspec

from omote.perform.clips.clip import Clip, Lane, find_lane, replace_span, with_changed_lane, with_lane
from omote.perform.clips.clip_parts import CLIP_PARTS, ClipPart
from omote.perform.clips.clip_runs import LONGEST_CLIP_NAME
from omote.perform.clips.cut_clip import CurveBuilder
from omote.perform.clips.motion_curve import MotionCurve
from omote.perform.clips.packed_motion import rounded
from omote.perform.limits import check_free, check_known, check_within
from omote.perform.scene.clip_goals import SETTING
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame
from omote.perform.snapshot import Playable
from omote.perform.speech.speaking import SOUND_LEAD_SECONDS
from omote.show.declaration import ClientMessage, Outgoing
from omote.show.objects import clips as wire
from omote.show.objects.speech import PlaySound, StopSpeaking

LONGEST_PASS = 600.0
"""Seconds; what is longer is cut into clips."""
SLOWEST_PASS = 0.25
"""Of the clip's own time: what is played more slowly looks like no motion to who plays along."""
TRIM_ROUNDS = 1e-3
"""Seconds by which pages round where a clip begins and ends."""
FEWEST_FRAMES = 3
"""Of a pass that is kept; the first stands where the pass begins too."""
MEETING_SECONDS = 0.1
"""In which the other lanes come when a pass begins."""
NO_WORK = wire.ClipWork([], 0)
"""No pass is recorded, and no clip was edited."""


@dataclass(frozen=True)
class Pass:
    """A pass that is recorded. name: of the clip; parts, lane: of the new lane; began: seconds of the scene; offset:
    what the time of the clip is then; by: who records it; sound: that the clip has from now on, "" for that which it
    has; speed: seconds of the clip a second of the scene."""

    name: str
    parts: tuple[ClipPart, ...]
    lane: str
    began: float
    offset: float
    builder: CurveBuilder
    by: str = ""
    sound: str = ""
    speed: float = 1.0

    def at(self, time: float) -> float:
        """What the time of the clip is. time: seconds of the scene."""
        return (time - self.began) * self.speed + self.offset


class ShowClips:
    """The clips of a show, by name.

    scene, cast: those that the session has now; check_sound: gives the key of a sound, by its name too, ValueError
    for one that is not there; list_names: tells consoles the names of a kind of documents; play: has a command
    played, as if somebody had sent it; edited: called after each edit; lose: told, in a sentence, what there is
    nobody to refuse it to.
    """

    def __init__(
        self,
        scene: Callable[[], Scene],
        cast: Callable[[], Playable],
        check_sound: Callable[[str], str],
        list_names: Callable[[str, list[str]], list[Outgoing]],
        play: Callable[[ClientMessage], object],
        edited: Callable[[], None],
        lose: Callable[[str], None],
    ) -> None:
        self._scene = scene
        self._cast = cast
        self._check_sound = check_sound
        self._list_names = list_names
        self._play = play
        self._edited = edited
        self._lose = lose
        self.clips: Mapping[str, Clip] = {}
        self._kept: Mapping[str, Clip] = {}
        self._dropped = dict[str, Clip]()
        self._passes = dict[str, Pass]()
        self._over: list[str] = []
        self._time = 0.0
        self._edits = 0
        self._told = NO_WORK

    def load(self, clips: Mapping[str, Clip]) -> None:
        """Plays the clips of a show file."""
        self.clips = dict(clips)
        self._kept = self.clips
        self._scene().set_clips(self.clips)
        self._edited()

    def take_changes(self) -> dict[str, Clip | None]:
        """Returns what the show file does not have yet, by name; None for what is gone."""
        before = self._kept
        now = self.clips
        if before is now:
            return {}
        self._kept = now
        return {name: now.get(name) for name in {**before, **now} if now.get(name) is not before.get(name)}

    @property
    def passes(self) -> Mapping[str, Pass]:
        """The passes that are recorded, by character."""
        return self._passes

    def note(self, frame: SceneFrame) -> None:
        """Notes what shows, for those who record; once where no time has gone by. frame: of the scene."""
        if frame.time <= self._time:
            return
        self._time = frame.time
        for character, running in self._passes.items():
            shown = frame.characters.get(character)
            if shown is None or frame.time - running.began > LONGEST_PASS:
                self._over.append(character)
                continue
            if running.builder.frames == 0:
                running.builder.add(running.offset, shown.frame)
            running.builder.add(running.at(frame.time), shown.frame)

    def end_passes(self) -> list[Outgoing]:
        """Ends passes that are over by themselves; returns what consoles are told of it."""
        over = [character for character in dict.fromkeys(self._over) if character in self._passes]
        self._over = []
        told: list[Outgoing] = []
        for character in over:
            begun = self._passes[character].builder.frames >= FEWEST_FRAMES
            try:
                told += self._end_pass(character, keep=begun)
            except ValueError as error:
                self._lose(f"the pass of {character} is over and could not be kept: {error}.")
        return told

    @property
    def work(self) -> wire.ClipWork:
        """What is recorded, and how often clips were edited."""
        passes = [
            wire.ClipPass(
                character, each.name, list(each.parts), each.lane, each.by, each.began, each.offset, each.speed
            )
            for character, each in self._passes.items()
        ]
        return wire.ClipWork(passes, self._edits)

    def news(self) -> wire.ClipWork | None:
        """What consoles were not told yet of passes and edits; None where they know all."""
        work = self.work
        before = self._told
        self._told = work
        return None if work == before else work

    def outline(self, name: str) -> Callable[[], wire.ClipOutline] | None:
        """What draws a clip, away from the ticks; None where there is none of this name."""
        clip = self.clips.get(name)
        edits = self._edits
        return None if clip is None else lambda: wire.outline_clip(name, clip, edits)

    def edit(self, message: wire.ClipCommand, by: str) -> Sequence[Outgoing]:
        """Makes an edit; ValueError where it cannot be made. message: asks for it; by: who does."""
        if isinstance(message, wire.RecordClip):
            return self.record(message, by)
        return EDITS[type(message)](self, message)

    def put(self, name: str, clip: Clip) -> list[Outgoing]:
        """Keeps a clip under a name, new or in the place of the one of that name; ValueError where there are too many.
        Returns what consoles are told."""
        if name not in self.clips:
            check_room(self.clips)
        return self._with({**self.clips, name: clip})

    def add_pass(self, name: str, curve: MotionCurve, parts: Sequence[ClipPart] = (), lane: str = "") -> list[Outgoing]:
        """Keeps motion as a lane over the others of a clip, or as a new clip; returns what consoles are told.

        name: of the clip; curve: in the time of the clip; parts: that it gives, none: all; lane: what to call it.
        """
        made = Lane(rounded(curve), lane, tuple(parts) or CLIP_PARTS)
        clip = self.clips.get(name)
        if clip is not None:
            return self.put(name, with_lane(clip, made))
        return self.put(self._free(name), Clip([made], start=curve.start))

    # --- the edits ---

    def record(self, message: wire.RecordClip, by: str) -> Sequence[Outgoing]:
        """Begins a pass. message: says of whom; by: who records it."""
        scene = self._scene()
        character = check_known(message.character, [*scene], "character")
        if character in self._passes:
            raise ValueError(f"a pass of {character} is recorded already; keep it, or forget it, first")
        parts = tuple(message.parts) or CLIP_PARTS
        speed = check_within(message.speed, SLOWEST_PASS, 1.0, "the speed of a pass")
        clip = self.clips.get(message.name)
        name = message.name if clip is not None else self._free(message.name)
        offset = 0.0 if clip is None else clip.start if message.start is None else message.start
        if clip is not None:
            heard: dict[str, float] = {part: 1.0 for part in clip.parts if part not in parts}
            check_within(offset, clip.start, clip.end, "where a pass begins (seconds of the clip)")
            if heard:
                start = offset - clip.start
                again = wire.PlayClip(
                    character, name, name, MEETING_SECONDS, start, speed=speed, loop=False, weights=heard
                )
                self._play(again)
        self._play_along(character, message.sound, clip, offset, speed)
        builder = CurveBuilder(self._cast())
        self._passes[character] = Pass(name, parts, message.lane, self._time, offset, builder, by, message.sound, speed)
        return ()

    def _play_along(self, character: str, sound: str, clip: Clip | None, offset: float, speed: float) -> None:
        """Has the sound heard to which a pass is played: a new one a moment later, so that its beginning is heard; that
        of the clip where the clip has it, if it is there. offset: what the time of the clip is; speed: of the pass; at
        another than 1 none is heard, as of a clip."""
        named = sound or ("" if clip is None else clip.sound)
        if not named:
            return
        try:
            key = self._check_sound(named)
        except ValueError as error:
            if sound:
                raise
            self._lose(f"a pass of {character} is recorded without its sound: {error}.")
            return
        if speed != 1.0:
            why = f"it plays at the speed {speed:g}, its sound at 1 alone"
            self._lose(f"a pass of {character} is recorded without its sound: {why}.")
            return
        delay = SOUND_LEAD_SECONDS if sound or clip is None else clip.sound_at - offset
        self._play(PlaySound(character, key, key, delay))

    def end_pass(self, message: wire.KeepPass) -> Sequence[Outgoing]:
        """Ends a pass. message: says of whom, and whether it is kept."""
        if message.character not in self._passes:
            raise ValueError(f"no pass of {message.character} is recorded; record one first")
        return self._end_pass(message.character, keep=message.keep)

    def _end_pass(self, character: str, *, keep: bool) -> list[Outgoing]:
        ended = self._passes.pop(character)
        scene = self._scene()
        clip = self.clips.get(ended.name)
        if character in scene:
            self._play(wire.StopClip(character, ended.name))
            if ended.speed == 1.0 and (ended.sound or (clip is not None and clip.sound)):
                self._play(StopSpeaking(character))
        if not keep:
            return []
        if ended.builder.frames < FEWEST_FRAMES:
            raise ValueError("the pass has no frames yet, so nothing is kept of it")
        told = self.add_pass(ended.name, ended.builder.curve(), ended.parts, ended.lane)
        if not ended.sound:
            return told
        lead = SOUND_LEAD_SECONDS if ended.speed == 1.0 else 0.0
        heard = replace(self._named(ended.name), sound=ended.sound, sound_at=ended.offset + lead)
        return [*told, *self.put(ended.name, heard)]

    def edit_clip(self, message: wire.EditClip) -> Sequence[Outgoing]:
        """A clip with other settings. message: says which."""
        if message.sound:
            self._check_sound(message.sound)
        clip = self._named(message.name)
        last = max(lane.stop for lane in clip.lanes)
        for what, time in (("start", message.start), ("stop", message.stop)):
            if time is not None and time > last + TRIM_ROUNDS:
                raise ValueError(
                    f"the {what} of the clip {message.name} is {time:g} s, but its lanes end at {last:.3f} s; "
                    "give that at most"
                )
        return self.put(message.name, replace(clip, **_given(message, wire.CLIP_SETTINGS)))

    def edit_lane(self, message: wire.EditLane) -> Sequence[Outgoing]:
        """A clip with another lane. message: says which."""
        clip = self._named(message.name)
        changes = _given(message, ("parts", "weight", "muted", "shift"))
        if message.to is not None:
            changes["name"] = message.to
        lane = replace(clip.lanes[find_lane(clip, message.lane)], **changes)
        return self.put(message.name, with_changed_lane(clip, message.lane, lane))

    def replace_span(self, message: wire.ReplaceSpan) -> Sequence[Outgoing]:
        """A clip in which a lane shows another for a while. message: says which."""
        clip = self._named(message.name)
        lane = clip.lanes[find_lane(clip, message.lane)]
        by = clip.lanes[find_lane(clip, message.by)]
        if lane is by:
            raise ValueError(f"the lane {message.lane} cannot be replaced by itself; name another")
        moved = MotionCurve(by.curve.times + (by.shift - lane.shift), by.curve.layout, by.curve.table)
        replaced = replace_span(lane, message.start - lane.shift, message.stop - lane.shift, moved)
        lanes = [replaced if each is lane else each for each in clip.lanes if each is not by]
        return self.put(message.name, replace(clip, lanes=lanes))

    def drop_lane(self, message: wire.DropLane) -> Sequence[Outgoing]:
        """A clip without a lane. message: says which."""
        return self.put(message.name, with_changed_lane(self._named(message.name), message.lane, None))

    def rename(self, message: wire.RenameClip) -> Sequence[Outgoing]:
        """A clip under another name. message: says which."""
        clip = self._named(message.name)
        others = {name: each for name, each in self.clips.items() if name != message.name}
        return self._with({**others, self._free(message.to, others): clip})

    def copy(self, message: wire.CopyClip) -> Sequence[Outgoing]:
        """A clip under one more name. message: says which."""
        return self.put(self._free(message.to), self._named(message.name))

    def drop(self, message: wire.DropClip) -> Sequence[Outgoing]:
        """No clip of a name. message: says which."""
        self._dropped[message.name] = self._named(message.name)
        return self._with({name: clip for name, clip in self.clips.items() if name != message.name})

    def restore(self, message: wire.RestoreClip) -> Sequence[Outgoing]:
        """A clip that was dropped. message: says which."""
        clip = self._dropped[check_known(message.name, self._dropped, "clip")]
        return self.put(self._free(message.name), clip)

    # --- within ---

    def _with(self, clips: Mapping[str, Clip]) -> list[Outgoing]:
        told = clips.keys() != self.clips.keys()
        self.clips = clips
        self._edits += 1
        self._scene().set_clips(clips)
        self._edited()
        return self._list_names(wire.StoredClip.kind, sorted(clips)) if told else []

    def _named(self, name: str) -> Clip:
        return self.clips[check_known(name, self.clips, "clip")]

    def _free(self, name: str, others: Mapping[str, Clip] | None = None) -> str:
        return check_clip_name(name, self.clips if others is None else others)


def name_new_clip(name: str, others: Collection[str]) -> str:
    """Returns the name of one more clip; ValueError as of `check_clip_name`, and where there are as many clips as a
    show keeps. others: the names of the others."""
    check_room(others)
    return check_clip_name(name, others)


def check_room(clips: Collection[str]) -> None:
    """Raises ValueError where a show keeps no more clips than these, by name."""
    if len(clips) >= wire.MOST_CLIPS:
        raise ValueError(f"there are {wire.MOST_CLIPS} clips, which is as many as a show keeps; delete one")


def check_clip_name(name: str, others: Iterable[str]) -> str:
    """Returns the name of a new clip without spaces around it; ValueError for none, for one that is too long, and for
    one that another has, in any case. others: the names of the others."""
    text = " ".join(name.split())
    if not 0 < len(text) <= LONGEST_CLIP_NAME or not text.isprintable() or text.startswith(SETTING):
        raise ValueError(
            f"a clip cannot be called {name!r:.60}; give 1 to {LONGEST_CLIP_NAME} printable letters, no {SETTING} first"
        )
    check_free(text, others, "clip")
    return text


def _given(message: msgspec.Struct, names: Sequence[str]) -> dict[str, Any]:
    """What a message gives of some fields."""
    return {name: value for name in names if (value := getattr(message, name)) is not None}


EDITS: Mapping[type[wire.ClipCommand], Callable[[ShowClips, Any], Sequence[Outgoing]]] = {
    wire.KeepPass: ShowClips.end_pass,
    wire.EditClip: ShowClips.edit_clip,
    wire.EditLane: ShowClips.edit_lane,
    wire.ReplaceSpan: ShowClips.replace_span,
    wire.DropLane: ShowClips.drop_lane,
    wire.RenameClip: ShowClips.rename,
    wire.CopyClip: ShowClips.copy,
    wire.DropClip: ShowClips.drop,
    wire.RestoreClip: ShowClips.restore,
}
"""What makes each edit but the beginning of a pass."""
