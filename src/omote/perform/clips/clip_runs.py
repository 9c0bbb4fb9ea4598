"""The clips that a character plays: how far each is, how much of it shows, and all of them laid over one another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import reduce

import numpy as np

from omote.perform.clips.clip import FASTEST, LONGEST_SHIFT, SLOWEST, Clip, blend_at
from omote.perform.clips.clip_parts import CLIP_PARTS, PLACES, ClipPart, check_clip_part
from omote.perform.clips.motion_curve import LONGEST_CURVE
from omote.perform.clips.sample import Sample, lay_over, shares_of
from omote.perform.limits import FOREVER, LONGEST_CALL, check_call_seconds, check_within

MOST_RUNS = 8
"""Clips that a character plays at once: those that go make way within their blend."""
LONGEST_CLIP_NAME = 40


@dataclass(frozen=True)
class ClipRun:
    """A clip as it was called: plain values, for snapshots. The clip itself is found by its name.

    clip: its name; position: seconds from its start, at the speed 1; seconds: its length; weights: how much of it
    shows in each part; come: seconds since it was called; blend_in, blend_out: in which it comes and goes; gone:
    seconds since it was stopped, None while it was not, and `going`: in which it goes then; pace: at which its time
    goes, None for that of the show; number: counts what the character has played; start: where it began.
    """

    clip: str
    position: float
    seconds: float
    weights: Mapping[ClipPart, float]
    blend_in: float
    blend_out: float
    loop: bool = False
    speed: float = 1.0
    come: float = 0.0
    gone: float | None = None
    pace: float | None = None
    number: int = 0
    going: float = 0.0
    start: float = 0.0

    @property
    def left(self) -> float:
        """Seconds until it is over, by its own time; endless for one that begins again and again."""
        return FOREVER if self.loop else (self.seconds - self.position) / self.speed

    @property
    def is_over(self) -> bool:
        """Whether nothing of it shows any more, or ever will."""
        return self.left <= 0.0 or (self.gone is not None and self.gone >= self.going)

    @property
    def share(self) -> float:
        """How much of it shows where it weighs all, 0 to 1."""
        share = blend_at(self.come, self.blend_in) if self.blend_in else 1.0
        if not self.loop and self.blend_out:
            share *= blend_at(self.left, self.blend_out)
        if self.gone is not None:
            share *= 1.0 - blend_at(self.gone, self.going) if self.going else 0.0
        return share


@dataclass(frozen=True)
class RunSound:
    """What is heard of the sound of a clip that plays. sound: its key, "" for nothing; elapsed: seconds since its
    begin; turn: how often the clip has begun again; silent: why nothing is heard of a clip that has a sound."""

    sound: str = ""
    elapsed: float = 0.0
    turn: int = 0
    silent: str = ""


NO_SOUND = RunSound()


def sound_of_run(run: ClipRun, clip: Clip | None) -> RunSound:
    """What is heard of a run's clip: a sound has one speed, and is not heard where the clip is stopped or held. clip:
    None where it is not there."""
    if clip is None or not clip.sound:
        return NO_SOUND
    if run.speed != 1.0:
        return RunSound(silent=f"the clip plays at the speed {run.speed:g}, its sound at 1 alone")
    if run.gone is not None:
        return RunSound(silent="the clip is stopped")
    if run.pace not in (None, 1.0):
        return RunSound(silent="the cues are paused")
    turn = round((run.start + run.come - run.position) / (run.seconds - _seam_of(run))) if run.loop else 0
    return RunSound(clip.sound, clip.start + run.position - clip.sound_at, turn)


def check_weights(weights: Mapping[str, float] | None, parts: tuple[ClipPart, ...]) -> dict[ClipPart, float]:
    """The weight of each part of a clip, 0 to 1; ValueError and TypeError for parts that there are not, and for
    numbers out of range. weights: by part, None for all of them; parts: those that the clip has."""
    if weights is None:
        return dict.fromkeys(parts, 1.0)
    chosen = {check_clip_part(part): check_within(value, 0.0, 1.0, f"the weight of a clip on {part}")
              for part, value in weights.items()}  # fmt: skip
    return {part: chosen[part] for part in parts if chosen.get(part)}


def run_of(
    clip: Clip,
    name: str,
    *,
    seconds: float | None,
    start: float,
    speed: float | None,
    loop: bool | None,
    weights: Mapping[str, float] | None,
    number: int,
) -> ClipRun:
    """A clip that begins to play; ValueError and TypeError for what cannot be played so.

    clip: it; name: by which it is found again; seconds: in which it comes, None as the clip says; start: seconds from
    its start; speed: 1 is as it was recorded, None as the clip says; loop: None as the clip says; weights:
    how much of it shows by part, None for all; number: counts what was played.
    """
    blend = clip.blend_in if seconds is None else check_call_seconds(seconds)
    position = check_within(start, 0.0, LONGEST_SHIFT, "the place in a clip (seconds)")
    if position >= clip.seconds:
        raise ValueError(f"{name} is {clip.seconds:.3g} s long; it cannot begin at {position:g} s")
    return ClipRun(
        name,
        position,
        clip.seconds,
        check_weights(weights, clip.parts),
        blend,
        clip.blend_out,
        clip.loop if loop is None else loop,
        check_within(clip.speed if speed is None else speed, SLOWEST, FASTEST, "the speed of a clip"),
        number=number,
        start=position,
    )


def advance_run(run: ClipRun, dt: float) -> ClipRun:
    """A run some seconds of the show later (dt); a loop goes on from its start, from where it has blended over to."""
    own = dt if run.pace is None else dt * run.pace
    if not own:
        return run
    position = run.position + own * run.speed
    turn = run.seconds - _seam_of(run)
    while run.loop and position >= run.seconds:
        position -= turn
    gone = None if run.gone is None else run.gone + own
    return replace(run, position=position, come=run.come + own, gone=gone)


def stopped(run: ClipRun, seconds: float | None) -> ClipRun:
    """A run that goes from now on, in some seconds; None as it was called. One that goes already goes on."""
    if run.gone is not None:
        return run
    blend = run.blend_out if seconds is None else check_call_seconds(seconds)
    return replace(run, gone=0.0, going=blend)


def sample_run(run: ClipRun, clip: Clip) -> Sample:
    """What a run shows now. clip: that of its name."""
    found = clip.sample(min(run.position, clip.seconds))
    seam = _seam_of(run)
    into = run.position - (run.seconds - seam)
    if run.loop and seam and into > 0.0:
        found = _blended(found, clip.sample(into), blend_at(into, seam))
    share = run.share
    held = shares_of(np.array([share * run.weights.get(part, 0.0) for part in CLIP_PARTS]))
    return Sample(found.layout, found.values, found.shares * held)


def sample_runs(runs: Sequence[ClipRun], clips: Mapping[int, Clip]) -> Sample | None:
    """What all runs show, the newest over the others; None where there are none.

    runs: the oldest first; clips: by the numbers of the runs.
    """
    samples = [sample_run(run, clips[run.number]) for run in runs]
    return reduce(lay_over, samples) if samples else None


def advance_runs(runs: tuple[ClipRun, ...], dt: float) -> tuple[ClipRun, ...]:
    """All runs some seconds later, without those that are over; where a newer one shows altogether, older ones are
    gone, so that it is not they who show once it ends.

    runs: the oldest first; dt: seconds of the show.
    """
    kept: list[ClipRun] = []
    hidden = set[ClipPart]()
    for run in (advance_run(each, dt) for each in reversed(runs)):
        weights = {part: weight for part, weight in run.weights.items() if part not in hidden}
        if weights and not run.is_over:
            kept.append(run if len(weights) == len(run.weights) else replace(run, weights=weights))
            if run.share == 1.0:
                hidden |= {part for part, weight in weights.items() if weight == 1.0}
    return tuple(reversed(kept))


def check_runs(runs: tuple[ClipRun, ...]) -> tuple[ClipRun, ...]:
    """Returns what was read; ValueError where no performer can play it so."""
    if len(runs) > MOST_RUNS:
        raise ValueError(f"a snapshot plays {len(runs)} clips; expected at most {MOST_RUNS}")
    for run in runs:
        for place in (run.position, run.start):
            check_within(place, 0.0, FOREVER, "the place in a clip (seconds)")
        check_within(run.seconds, 0.0, LONGEST_CURVE, "the length of a clip (seconds)")
        check_within(run.speed, SLOWEST, FASTEST, "the speed of a clip")
        check_weights({str(part): weight for part, weight in run.weights.items()}, CLIP_PARTS)
        for seconds in (run.blend_in, run.blend_out, run.going):
            check_within(seconds, 0.0, LONGEST_CALL, "the blend of a clip (seconds)")
        for seconds in (run.come, run.gone or 0.0):
            check_within(seconds, 0.0, FOREVER, "the time of a clip (seconds)")
        check_within(1.0 if run.pace is None else run.pace, 0.0, 1.0, "the pace of a clip")
    return runs


def _seam_of(run: ClipRun) -> float:
    """Seconds of a clip in which its end goes over into its beginning, where it begins again."""
    return min(run.blend_in * run.speed, 0.5 * run.seconds) if run.loop else 0.0


def _blended(ends: Sample, begins: Sample, part: float) -> Sample:
    """The end of a loop as it goes over into its beginning."""
    mixed = lay_over(
        Sample(ends.layout, ends.values, np.ones(PLACES)),
        Sample(begins.layout, begins.values, np.full(PLACES, part)),
    )
    return Sample(mixed.layout, mixed.values, ends.shares + part * (begins.shares - ends.shares))
