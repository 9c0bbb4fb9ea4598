"""The part of a performer that plays clips."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from omote.arrays import Values
from omote.model.known_names import NEUTRAL, PLAY_REGIONS
from omote.model.space.expression import Expression
from omote.perform.clips.clip import Clip
from omote.perform.clips.clip_runs import (
    MOST_RUNS,
    ClipRun,
    advance_runs,
    run_of,
    sample_runs,
    sound_of_run,
    stopped,
)
from omote.perform.clips.played_body import PlayedBodies, PlayedBody, wear_body
from omote.perform.clips.sample import CHANNEL, GAZE_COLUMNS, HEAD_COLUMNS, Layout, Sample
from omote.perform.frame import ClipStatus, Frame, Gaze, Head, with_fields
from omote.perform.layers.layer_mix import CLIP_LAYER, NO_MIXES, Mixes
from omote.perform.layers.layer_names import DEFAULT_SETTINGS, LAYER_PARTS, WHOLE, LayerName, LayerPart
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.source_frame import CLIP, SourceFrame
from omote.perform.limits import CHANNEL_HIGHEST, CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS
from omote.perform.mix import HIGHEST, LOWEST
from omote.perform.pad_playing import PadPlaying

NO_CLIPS: Mapping[int, Clip] = {}


class WornLayout:
    """Which columns of a layout a cast has, and what of it is left out. layout: of a motion; expressions: the cast's,
    by name; bones: of its figures."""

    def __init__(self, layout: Layout, expressions: Mapping[str, Expression], bones: Sequence[str] = ()) -> None:
        index = {column: place for place, column in enumerate(layout.columns)}
        named = [(column, *column.split("/", 1)) for column in layout.columns]
        worn = [(index[column], name) for column, part, name in named if part == CHANNEL and name in expressions]
        self.channels = tuple(name for _, name in worn)
        self.places = np.array([place for place, _ in worn], np.intp)
        self.mixes = {
            region: {
                place: name if name in expressions else NEUTRAL
                for place, (_, part, name) in enumerate(named)
                if part == region
            }
            for region in PLAY_REGIONS
        }
        self.bodies = PlayedBodies(layout.columns, bones)
        self.head = [index[column] for column in HEAD_COLUMNS if column in index]
        self.gaze = [index[column] for column in GAZE_COLUMNS if column in index]
        is_named = {CHANNEL, *PLAY_REGIONS}
        self.missing = tuple(sorted({name for _, part, name in named if part in is_named and name not in expressions}))

    def frame(self, sample: Sample, parts: tuple[LayerPart, ...]) -> SourceFrame:
        """The frame of channels, head and gaze. sample: of this layout; parts: those that it may play."""
        values = sample.values
        shares = np.clip(sample.shares[: WHOLE + 1], 0.0, 1.0).tolist()
        head = None
        if self.head:
            head = Head(
                *(float(np.clip(values[at], -limit, limit)) for at, limit in zip(self.head, _TURNS, strict=True))
            )
        gaze = None
        if self.gaze:
            gaze = Gaze(
                *(float(np.clip(values[at], -limit, limit)) for at, limit in zip(self.gaze, _LOOKS, strict=True))
            )
        return SourceFrame(
            self.channels,
            np.clip(values[self.places], CHANNEL_LOWEST, CHANNEL_HIGHEST),
            head,
            gaze,
            source=CLIP,
            parts=parts,
            direct=True,
            part_shares=tuple(shares),
        )

    def mixes_of(self, sample: Sample) -> Mixes:
        """The mix of each region; what the cast does not have is neutral. sample: of this layout."""
        return {region: _mix(sample.values, columns) for region, columns in self.mixes.items()}


_TURNS = tuple(HEAD_LIMITS.values())
_LOOKS = tuple(GAZE_LIMITS.values())


def _mix(values: Values, names: Mapping[int, str]) -> dict[str, float]:
    """A mix of some columns; between frames of a jump a cubic goes beyond it, which neutral makes up for.

    names: by column; several that the cast does not have are neutral.
    """
    mix = dict[str, float]()
    beyond = 0.0
    for place, name in names.items():
        value = float(values[place])
        held = min(max(value, LOWEST), HIGHEST)
        beyond += value - held
        mix[name] = mix.get(name, 0.0) + held
    mix[NEUTRAL] += beyond
    return {name: mix[name] for name in sorted(mix) if mix[name]}


class ClipPlaying(PadPlaying):
    """Plays clips over all that moves a character but hands."""

    _clips: Mapping[int, Clip] = NO_CLIPS
    _worn: dict[Layout, WornLayout]
    _mixes: Mixes = NO_MIXES
    _played: SourceFrame | None = None
    _body: PlayedBody | None = None
    _layers: Layers | None

    def play_clip(
        self,
        clip: Clip,
        *,
        name: str = "clip",
        seconds: float | None = None,
        start: float = 0.0,
        speed: float | None = None,
        loop: bool | None = None,
        weights: Mapping[str, float] | None = None,
        pace: float | None = None,
    ) -> None:
        """Plays a motion clip on the layer playback, from whatever shows; it goes by itself before its end.

        A clip that plays already makes way, in the parts of this one, within its blend. Expressions and channels that
        the cast does not have are left out, and the frame's `clips` name them.

        Parameters
        ----------
        clip : Clip
            What is played.
        name : str
            By which it is shown, and found again after a restart.
        seconds : float, optional
            In which it comes, 0 (a cut) to 3600; as the clip says without it. It goes as the clip says.
        start : float
            Seconds from its start.
        speed : float, optional
            0.05 to 20; as the clip says without it.
        loop : bool, optional
            Whether it begins again at its end; as the clip says without it.
        weights : mapping of float, optional
            How much of it shows in brows, eyes, mouth, rest, head, gaze and body, 0 to 1; what is not named is left
            alone. All of it without them.
        pace : float, optional
            As of `Scene.call_goal`.

        Raises
        ------
        ValueError
            On parts that there are not, numbers out of range, and more than eight clips at once.
        TypeError
            On what is no clip or no number.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> other = omote.Performer(cast)
        >>> other.call_expression("smile", seconds=1)
        >>> clip = omote.Clip([omote.Lane(record(other, cast, seconds=1.0))])
        >>> performer = omote.Performer(cast)
        >>> performer.play_clip(clip, seconds=0)
        >>> round(performer.advance(0.5).expressions["smile"], 3)
        0.5

        References
        ----------
        docs/method.md, "Clips".
        """
        if not isinstance(clip, Clip):
            raise TypeError(f"the clip is a {type(clip).__name__}; give an omote.Clip")
        runs = self._now.clips
        if len(runs) >= MOST_RUNS:
            raise ValueError(f"{MOST_RUNS} clips play already; wait until one has made way, or stop them")
        number = self._now.played + 1
        run = run_of(
            clip, name, seconds=seconds, start=start, speed=speed, loop=loop, weights=weights, number=number
        )  # fmt: skip
        self._clips = {**self._clips, number: clip}
        self._play(clips=(*runs, replace(run, pace=pace)), played=number)
        # Its layer is trusted before anything of it shows: so it comes as fast as it likes, and first as it is.
        self._show_clips(
            [
                *(each for each in runs if each.number in self._clips),
                replace(run, weights=dict.fromkeys(run.weights, 0.0)),
            ]
        )

    def stop_clip(self, name: str = "", *, seconds: float | None = None) -> None:
        """Ends clips: what lies below shows again.

        Parameters
        ----------
        name : str
            Of the clip; "" for all that play.
        seconds : float, optional
            In which it goes, 0 (a cut) to 3600; as the clip says without it.

        Raises
        ------
        ValueError
            On seconds out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> performer = omote.Performer(cast)
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> performer.play_clip(clip)
        >>> performer.stop_clip(seconds=0)
        >>> performer.advance(0.1).clips
        ()
        """
        runs = tuple(stopped(run, seconds) if name in ("", run.clip) else run for run in self._now.clips)
        self._play(clips=runs)

    def find_clips(self, clips: Mapping[str, Clip]) -> None:
        """Goes on with the clips of a snapshot; one that is not there any more is over.

        Parameters
        ----------
        clips : mapping of Clip
            All that there are, by name.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> performer = omote.Performer(cast)
        >>> performer.play_clip(clip, name="line1")
        >>> again = omote.Performer.restored(cast, performer.snapshot())
        >>> again.find_clips({"line1": clip})
        >>> again.advance(0.1) == performer.advance(0.1)
        True
        """
        found = {run.number: clips[run.clip] for run in self._now.clips if run.clip in clips}
        self._clips = {**found, **self._clips}

    def clips_playing(self) -> dict[int, Clip]:
        """The clips that play, as they were called, whatever was edited since.

        Returns
        -------
        dict of Clip
            By the numbers of their runs.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> performer = omote.Performer(cast)
        >>> performer.play_clip(clip, name="line1")
        >>> [*performer.clips_playing().values()] == [clip]
        True
        """
        return {run.number: self._clips[run.number] for run in self._now.clips if run.number in self._clips}

    def resume_clips(self, clips: Mapping[int, Clip]) -> None:
        """Goes on with clips that were edited or dropped since they were called, before `find_clips` finds the others.

        Parameters
        ----------
        clips : mapping of Clip
            By the numbers of their runs.

        Examples
        --------
        >>> from omote.perform.clips.cut_clip import record
        >>> clip = omote.Clip([omote.Lane(record(omote.Performer(cast), cast, seconds=1.0))])
        >>> performer = omote.Performer(cast)
        >>> performer.play_clip(clip, name="line1")
        >>> again = omote.Performer.restored(cast, performer.snapshot())
        >>> again.resume_clips(performer.clips_playing())
        >>> again.advance(0.1) == performer.advance(0.1)
        True
        """
        self._clips = {**self._clips, **clips}

    def _advance_clips(self, dt: float) -> None:
        """Clips go on, and play their layer."""
        before = self._now.clips
        if not before:
            return
        runs = advance_runs(tuple(run for run in before if run.number in self._clips), dt)
        self._now = with_fields(self._now, clips=runs)
        self._show_clips(runs)
        self._clips = {run.number: self._clips[run.number] for run in runs}

    def _show_clips(self, runs: Sequence[ClipRun]) -> None:
        """Plays what runs show on the layer of clips; where there are none, it lets go.

        runs: the oldest first.
        """
        sample = sample_runs(runs, self._clips)
        if sample is not None:
            worn = self._wear(sample.layout)
            played = {part for run in runs for part in run.weights}
            frame = worn.frame(sample, tuple(part for part in LAYER_PARTS if part in played))
            self._played = frame
            self._mixes = worn.mixes_of(sample)
            self._body = worn.bodies.body(sample)
            self.drive_layer(CLIP_LAYER, frame)
            return
        if self._played is not None:  # nothing of it shows from now on, even of one that was cut
            self.drive_layer(CLIP_LAYER, replace(self._played, part_shares=(0.0,) * (WHOLE + 1)))
        self.leave_layer(CLIP_LAYER, CLIP)
        self._forget_clips()

    def _forget_clips(self) -> None:
        """Nothing is played any more."""
        self._clips = NO_CLIPS
        self._mixes = NO_MIXES
        self._played = None
        self._body = None

    def _with_body(self, frame: Frame) -> Frame:
        """A frame with the body that clips play, as much as their layer shows of all parts."""
        body = self._body_on_air()
        return frame if body is None else with_fields(frame, figure=wear_body(frame.figure, body))

    def _body_on_air(self) -> PlayedBody | None:
        """The body that clips play, as much as their layer shows of all parts; None where nothing of it does."""
        if self._body is None:
            return None
        setting = DEFAULT_SETTINGS[CLIP_LAYER] if self._layers is None else self._layers.settings[CLIP_LAYER]
        share = self._body.share * (sum(setting.by_part) / len(LAYER_PARTS) if setting.on else 0.0)
        return replace(self._body, share=share) if share else None

    def _wear(self, layout: Layout) -> WornLayout:
        worn = self._worn.get(layout)
        if worn is None:
            worn = self._worn[layout] = WornLayout(layout, self._cast.expressions, self._cast.bones)
        return worn

    def _clip_statuses(self) -> tuple[ClipStatus, ...]:
        """The clips that play, the newest last."""
        return tuple(self._clip_status(run) for run in self._now.clips)

    def _clip_status(self, run: ClipRun) -> ClipStatus:
        sound = sound_of_run(run, self._clips.get(run.number))
        return ClipStatus(
            run.clip,
            run.position,
            run.seconds,
            run.share,
            run.loop,
            self._missing_of(run),
            run.number,
            sound.sound,
            sound.elapsed,
            sound.turn,
            sound.silent,
        )

    def _missing_of(self, run: ClipRun) -> tuple[str, ...]:
        clip = self._clips.get(run.number)
        layouts = {} if clip is None else dict.fromkeys(lane.curve.layout for lane in clip.lanes)
        return tuple(sorted({name for layout in layouts for name in self._wear(layout).missing}))

    def drive_layer(self, layer: LayerName, frame: SourceFrame) -> None:
        """Takes one frame of a source. layer: that it drives; frame: checked."""
        raise NotImplementedError

    def leave_layer(self, layer: LayerName, source: str) -> None:
        """Fades out the layer of a source. layer: that it drives; source: its name."""
        raise NotImplementedError
