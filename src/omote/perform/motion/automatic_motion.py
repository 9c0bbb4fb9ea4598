"""The automatic motion of a character: all that it does by itself, as frames for the layers blink, gaze and breath."""

from __future__ import annotations

import math
from collections.abc import Container
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from omote.perform.frame import NO_TARGET, Gaze, Head, MotionSettings
from omote.perform.layers.follower import follow_number, rate_of
from omote.perform.layers.layer_names import DRIVEN, RANGES, LayerName
from omote.perform.layers.layer_vectors import Layers, trust_of
from omote.perform.layers.source_frame import AUTOMATIC, SourceFrame
from omote.perform.limits import FOREVER, check_within
from omote.perform.motion.blinks import Blinks, advance_blinks, begin_blink, lid_closure
from omote.perform.motion.breathing import (
    BREATH_CHANNELS,
    BREATH_PITCH,
    NOISE_CHANNELS,
    NOISE_HEAD,
    NOISES,
    Breath,
    advance_breath,
    air,
    noise,
)
from omote.perform.motion.gaze_motion import DEGREE, OTHER_GOAL, GazeMotion, advance_gaze, looked_at
from omote.perform.motion.head_following import FollowingHead, Turn, follow_gaze
from omote.perform.motion.sight import NOTHING, Sight

LIDS = ("eyeBlinkLeft", "eyeBlinkRight")
MOST_OFFSET = RANGES["offset"][1]
SHORTEST_SPAN = 1e-3
FARTHEST = 8.0
DEEPEST = 4.0 + 1e-6
DEPTH_SECONDS = 1.0
"""In which breath and noise follow what is set."""
IDLE_LIVELINESS = 0.5
"""How much a character idles that holds still otherwise: as people move."""
PURSUIT = 40.0 * DEGREE
"""Radians a second at which eyes follow what moves (Meyer, Lasker and Robinson 1985, *Vision Research* 25: to 90)."""
VERGENCE_SECONDS = 0.5
"""In which eyes converge (Hung et al. 1997: 0.4 to 0.6)."""
MOST_VERGENCE = 0.5
EYE_RANGE = Turn(0.6, 0.38)
"""Radians (34 and 22 degrees) sideways and up that eyes turn in a head by themselves, less where they do both (Stahl
2001, *Experimental Brain Research* 139: the customary range); the head brings what lies beyond."""
_WEIGHT = NOISES + len(NOISE_HEAD)
"""Which noise shifts the weight."""
WEIGHT_SLOWER = 4.0
"""Times: people who stand at ease shift their weight every 10 to 60 seconds (Duarte and Zatsiorsky 1999, *Motor
Control* 3: 'shifting' in natural standing)."""
MOTION_LAYERS: tuple[LayerName, ...] = ("breath", "gaze", "blink")


@dataclass(frozen=True)
class AutomaticMotion:
    """What a character does by itself. time: seconds since it began; depth: of breath and noise, after both filters;
    vergence: how far each eye turns in, radians, after both filters; lost: its tracker is lost."""

    settings: MotionSettings = field(default_factory=MotionSettings)
    time: float = 0.0
    blinks: Blinks = field(default_factory=Blinks)
    gaze: GazeMotion = field(default_factory=GazeMotion)
    head: FollowingHead = field(default_factory=FollowingHead)
    breath: Breath = field(default_factory=Breath)
    depth: tuple[float, float] = (0.0, 0.0)
    vergence: tuple[float, float] = (0.0, 0.0)
    lost: bool = False

    @property
    def acting(self) -> MotionSettings:
        """The settings by which it moves now: where it idles, those of people."""
        idles = self.lost and self.settings.idle and self.settings.liveliness == 0.0
        return _idle(self.settings) if idles else self.settings


@lru_cache(maxsize=64)
def _idle(settings: MotionSettings) -> MotionSettings:
    return settings.change(liveliness=IDLE_LIVELINESS)


def is_moving(motion: AutomaticMotion) -> bool:
    """Whether it does anything by itself."""
    return motion.acting.liveliness > 0.0 or motion.settings.target != NO_TARGET


def set_motion(motion: AutomaticMotion, settings: MotionSettings) -> AutomaticMotion:
    """The motion under other settings: what shows goes on from where it is."""
    return replace(motion, settings=settings)


def check_motion(motion: AutomaticMotion | None) -> AutomaticMotion | None:
    """Returns a motion that was read; ValueError where none can be so."""
    if motion is None:
        return None
    check_within(motion.time, 0.0, FOREVER, "the time of the automatic motion (seconds)")
    blinks = motion.blinks
    gaze = motion.gaze
    breath = motion.breath
    check_within(blinks.depth, 0.0, 1.0, "the depth of a blink")
    spans = blinks.down, blinks.up, breath.seconds, gaze.saccade.seconds
    for seconds in spans:
        check_within(seconds, SHORTEST_SPAN, FOREVER, "a span of the automatic motion (seconds)")
    turns = gaze.seen, gaze.saccade.origin, gaze.saccade.goal, motion.head.first, motion.head.second
    for turn in turns:
        for angle in (turn.yaw, turn.pitch):
            check_within(angle, -FARTHEST, FARTHEST, "an angle of the automatic motion (radians)")
    for turned in motion.vergence:
        check_within(turned, -MOST_VERGENCE, MOST_VERGENCE, "the vergence of the eyes (radians)")
    for depth in motion.depth:
        check_within(depth, 0.0, DEEPEST, "the depth of the breath")
    for at in (blinks.began, blinks.due, gaze.spell, gaze.fixation, gaze.saccade.began, breath.began):
        check_within(at, -FOREVER, FOREVER, "a time of the automatic motion (seconds)")
    return motion


def advance_motion(
    motion: AutomaticMotion, dt: float, *, sight: Sight = NOTHING, speaking: bool = False
) -> AutomaticMotion:
    """The motion `dt` seconds later.

    Parameters
    ----------
    motion : AutomaticMotion
        As it is.
    dt : float
        Seconds, 0 or more.
    sight : Sight
        What is looked at.
    speaking : bool
        Whether the character speaks: it blinks oftener then, and most of all when it ends.

    Returns
    -------
    AutomaticMotion
        Frozen; the same motion and steps give the same bits.
    """
    settings = motion.acting
    now = motion.time + dt
    seen = _pursued(motion.gaze.seen, sight.turn, dt)
    gaze = advance_gaze(motion.gaze, settings.seed, now, seen, reach=settings.reach, contact=sight.contact)
    blinks = advance_blinks(motion.blinks, settings.seed, now, dt, rate=settings.blink_rate, speaking=speaking)
    if gaze.lids and settings.blink_rate > 0.0:
        blinks = begin_blink(blinks, settings.seed, now, whole=True)
    head = follow_gaze(motion.head, looked_at(gaze, now), dt)
    breath = advance_breath(motion.breath, settings.seed, now)
    depth = follow_number(*motion.depth, settings.depth, rate_of(DEPTH_SECONDS), dt)
    wanted = sight.vergence if gaze.contact else 0.0
    vergence = follow_number(*motion.vergence, wanted, rate_of(VERGENCE_SECONDS), dt)
    return AutomaticMotion(motion.settings, now, blinks, gaze, head, breath, depth, vergence, motion.lost)


def _pursued(before: Turn, seen: Turn, dt: float) -> Turn:
    """Where the eyes are that follow what moves: what is far off is reached by a saccade, not by pursuit."""
    way = seen - before
    far = abs(way.yaw) + abs(way.pitch)
    if far > OTHER_GOAL or far <= PURSUIT * dt:
        return seen
    return before + way.scale(PURSUIT * dt / far)


def motion_frames(motion: AutomaticMotion, names: Container[str]) -> dict[LayerName, SourceFrame]:
    """What the layers show now.

    Parameters
    ----------
    motion : AutomaticMotion
        The motion.
    names : container of str
        The channels that there are; what acts on others is left out.

    Returns
    -------
    dict of SourceFrame
        One for each of the layers breath, gaze and blink; without liveliness only the gaze, where it has a target.
    """
    if motion.acting.liveliness == 0.0:
        return {} if motion.settings.target == NO_TARGET else {"gaze": _gaze_frame(motion, _breath_head(motion))}
    has = tuple(name for name in _CHANNELS if name in names)
    lids = tuple(name for name in LIDS if name in names)
    shut = lid_closure(motion.blinks, motion.time)
    drawn = _breath_head(motion)
    return {
        "breath": SourceFrame(has, _breath_values(motion, has), drawn, source=AUTOMATIC, direct=True),
        "gaze": _gaze_frame(motion, drawn),
        "blink": SourceFrame(lids, np.full(len(lids), shut), source=AUTOMATIC, direct=True),
    }


def figure_idle(motion: AutomaticMotion) -> tuple[float, float]:
    """How much of a breath is in the chest (0 to 1, more where it is set deeper), and how far the weight is on the left
    foot, -1 to 1. motion: the character's."""
    depth = motion.depth[1]
    shift = depth * noise(motion.settings.seed, _WEIGHT, motion.time / WEIGHT_SLOWER)
    return depth * air(motion.breath, motion.time), min(max(shift, -1.0), 1.0)


def _gaze_frame(motion: AutomaticMotion, drawn: Head) -> SourceFrame:
    """Eyes and head: the eyes turn back by what the head has come (the vestibulo-ocular reflex). drawn: the breath's.

    The layer replaces what lies below, so that the head has breath and noise in it here too.
    """
    head = motion.head.second
    eyes = looked_at(motion.gaze, motion.time) - head
    share = _share_in_range(eyes)
    gaze = Gaze(share * eyes.yaw, share * eyes.pitch)
    return SourceFrame(
        (),
        np.zeros(0),
        Head(head.yaw + drawn.yaw, head.pitch + drawn.pitch, drawn.roll),
        gaze,
        source=AUTOMATIC,
        direct=True,
        vergence=motion.vergence[1],
    )


def _share_in_range(eyes: Turn) -> float:
    """How much of a turn lies within the range of the eyes, an ellipse."""
    side = eyes.yaw / EYE_RANGE.yaw
    height = eyes.pitch / EYE_RANGE.pitch
    beyond = side * side + height * height
    return 1.0 if beyond <= 1.0 else 1.0 / math.sqrt(beyond)


_CHANNELS = tuple(sorted({*BREATH_CHANNELS, *NOISE_CHANNELS}))


def _breath_values(motion: AutomaticMotion, names: tuple[str, ...]) -> np.ndarray:
    depth = motion.depth[1]
    drawn = air(motion.breath, motion.time)
    moved = np.array([noise(motion.settings.seed, kind, motion.time) for kind in range(NOISES)])
    breathed, kinds, far = _shares(names)
    added = depth * (breathed * drawn + far * moved[kinds])
    return np.asarray(np.minimum(np.maximum(added, -MOST_OFFSET), MOST_OFFSET))


@lru_cache(maxsize=64)
def _shares(names: tuple[str, ...]) -> tuple[NDArray[np.float64], NDArray[np.intp], NDArray[np.float64]]:
    """Of each channel how far a whole breath moves it, which noise does, and how far."""
    noises = [NOISE_CHANNELS.get(name, (0, 0.0)) for name in names]
    breathed = np.array([BREATH_CHANNELS.get(name, 0.0) for name in names])
    return breathed, np.array([kind for kind, _ in noises], np.intp), np.array([far for _, far in noises])


def _breath_head(motion: AutomaticMotion) -> Head:
    depth = motion.depth[1]
    seed = motion.settings.seed
    now = motion.time
    yaw, pitch, roll = (depth * far * noise(seed, NOISES + at, now) for at, far in enumerate(NOISE_HEAD))
    return Head(yaw, pitch + depth * BREATH_PITCH * air(motion.breath, now), roll)


SPOKEN = 0.1
"""Lips that are moved by more speak."""
SHOWN = 0.99
"""A tracker that is trusted by more hides what lies below."""
_TRACKER: LayerName = "tracker"


def is_free(layers: Layers, layer: LayerName) -> bool:
    """Whether no source drives a layer but the character's own motion. layers: those of a character."""
    return all(driver.source == AUTOMATIC for driver in layers.drivers.get(layer, ()))


def is_speaking(layers: Layers) -> bool:
    """Whether lips that a source drives move."""
    if not any(driver.is_trusted for driver in layers.drivers.get("lips", ())):
        return False
    lips = layers.columns.rows(layers.second, "streams")[DRIVEN.index("lips")]
    return bool(lips[: len(layers.columns.names)].max(initial=0.0) > SPOKEN)


def is_tracker_lost(layers: Layers | None, lost: bool) -> bool:
    """Whether the tracker that played is lost: silent, blind or gone, until another shows altogether; not while an
    operator, or a panic, has switched its layer off. lost: whether it was before.

    layers: those of a character.
    """
    if layers is None:
        return lost
    if not layers.settings[_TRACKER].on:
        return False
    drivers = layers.drivers.get(_TRACKER, ())
    if not drivers:
        return lost
    if any(driver.is_trusted for driver in drivers):
        return lost and float(trust_of(layers, _TRACKER).max()) < SHOWN
    return True
