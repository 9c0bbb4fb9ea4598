"""Curves of what showed of each character, ten times a second, and the cues that were called, from states as they were
sent: what a director compares of two runs, without a replay of either."""

from __future__ import annotations

import math
import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.model.known_names import NEUTRAL, PLAY_REGIONS, PlayRegion
from omote.model.space.expression import Title
from omote.perform.clips.cut_clip import HasTitles, place_of_channel
from omote.show.objects.state import Place

CURVE_RATE = 10
"""Samples a second."""
TIME_STEP = 1e-3
"""Seconds to which times are rounded: what was at an end of a stretch may lie so far beside it."""
PER_WEIGHT = 1000.0
"""Steps of a curve as it is kept; none leaves the 32,767 that there are."""
PER_DEGREE = 10.0
PER_METRE = 100.0
QUANTITIES: Mapping[str, float] = {
    "face": PER_WEIGHT,
    "expression": PER_WEIGHT,
    **dict.fromkeys(PLAY_REGIONS, PER_WEIGHT),
    "head_yaw": PER_DEGREE,
    "head_pitch": PER_DEGREE,
    "head_roll": PER_DEGREE,
    "gaze_yaw": PER_DEGREE,
    "gaze_pitch": PER_DEGREE,
    "x": PER_METRE,
    "depth": PER_METRE,
    "presence": PER_WEIGHT,
    "speaking": PER_WEIGHT,
}
"""What is kept of a character, with its steps a unit. face: the weight of the face that shows most; expression: of the
strongest that is not neutral; a region: the weight of the strongest that moves it, an expression or a channel; head and
gaze in degrees; x and depth in metres; speaking: 0 or 1."""
WORDS = ("face_name", "expression_name")
"""The names beside them, as places in a list of names."""
BLINKS = frozenset(("eyeBlinkLeft", "eyeBlinkRight"))
"""Channels that come by themselves every few seconds, at times of their own in each run: they would hide what is
played."""
MISSING = np.iinfo(np.int16).min
MOST_BYTES = 2**24
"""Of a minute's curves, unpacked: forty times those of four characters."""
_STEPS = np.array([*QUANTITIES.values(), *(1.0 for _ in WORDS)])

Values = NDArray[np.float64]


class ShownCharacter(msgspec.Struct, frozen=True):
    """What a curve needs of a character's state, of whose fields these have the names."""

    faces: dict[str, float]
    expressions: dict[str, float]
    channels: dict[str, float]
    head: tuple[float, float, float]
    gaze: tuple[float, float]
    place: Place
    presence: float
    regions: dict[PlayRegion, dict[str, float]] = {}
    speech: ShownSpeech | None = None


class ShownSpeech(msgspec.Struct, frozen=True):
    """How far a speech is, of how many seconds."""

    elapsed: float
    seconds: float


class ShownCue(msgspec.Struct, frozen=True):
    """The cue that was called last."""

    identity: str
    number: str


class ShownList(msgspec.Struct, frozen=True):
    """How far a list of cues is."""

    current: ShownCue | None = None
    since: float | None = None


class ShownCues(msgspec.Struct, frozen=True):
    """The lists of cues, by name."""

    lists: dict[str, ShownList] = {}


class Shown(msgspec.Struct, frozen=True):
    """What curves need of a state."""

    characters: dict[str, ShownCharacter]
    cues: ShownCues | None = None


class CueCall(NamedTuple):
    """A cue that was called. at: seconds of the machine's clock; cue_list: by name; number: of the cue."""

    at: float
    cue_list: str
    number: str


@dataclass(frozen=True)
class Curves:
    """Curves of characters. times: (n,), seconds of the machine's clock; values: by character, (n, q), a column for
    each of `QUANTITIES` and of `WORDS`, NaN where it was not there; names: those that the last columns mean."""

    times: Values
    values: Mapping[str, Values]
    names: tuple[str, ...] = ()

    def words(self, character: str, word: str) -> list[str]:
        """The names of one of `WORDS` at each time, "" where the character was not there. character: by name;
        word: which of them."""
        column = self.values[character][:, len(QUANTITIES) + WORDS.index(word)]
        return ["" if math.isnan(place) else self.names[int(place)] for place in column]

    def between(self, first: float, last: float) -> Curves:
        """What lies between two times (first, last), both with it."""
        inside = (self.times >= first - TIME_STEP) & (self.times <= last + TIME_STEP)
        return Curves(self.times[inside], {name: table[inside] for name, table in self.values.items()}, self.names)


_decoder = msgspec.msgpack.Decoder(Shown)


def sample_curves(times: Sequence[float], states: Sequence[Shown], cast: HasTitles) -> Curves:
    """Curves of some states. times: of each, seconds of the machine's clock; states: what was sent; cast: knows the
    regions of channels."""
    names: dict[str, int] = {}
    values: dict[str, Values] = {}
    for row, state in enumerate(states):
        for name, character in state.characters.items():
            if name not in values:
                values[name] = np.full((len(states), len(_STEPS)), np.nan)
            values[name][row] = _row_of(character, cast, names)
    return Curves(np.array(times, dtype=np.float64), values, tuple(names))


def _row_of(character: ShownCharacter, cast: HasTitles, names: dict[str, int]) -> list[float]:
    face = max(character.faces, key=character.faces.__getitem__, default="")
    expression = _strongest(character.expressions)
    head = [math.degrees(angle) for angle in (*character.head, *character.gaze)]
    speech = character.speech
    return [
        character.faces.get(face, 0.0),
        character.expressions.get(expression, 0.0) if expression != NEUTRAL else 0.0,
        *_regions_of(character, cast),
        *head,
        character.place.x,
        character.place.depth,
        character.presence,
        float(speech is not None and 0.0 <= speech.elapsed < speech.seconds),
        names.setdefault(face, len(names)),
        names.setdefault(expression, len(names)),
    ]


def _strongest(mix: Mapping[str, float]) -> str:
    """The strongest of a mix that is not neutral; neutral where there is nothing else."""
    shown = [name for name, weight in mix.items() if name != NEUTRAL and abs(weight) > 0.5 / PER_WEIGHT]
    return max(shown, key=lambda name: abs(mix[name]), default=NEUTRAL)


def _regions_of(character: ShownCharacter, cast: HasTitles) -> list[float]:
    """How strongly each region is moved, by the strongest expression or channel."""
    mixes = [character.regions.get(region, character.expressions) for region in PLAY_REGIONS]
    moved = [max((abs(weight) for name, weight in mix.items() if name != NEUTRAL), default=0.0) for mix in mixes]
    for name, weight in character.channels.items():
        place = place_of_channel(name, cast)
        if name not in BLINKS and place < len(moved):
            moved[place] = max(moved[place], abs(weight))
    return moved


class CueWatch:
    """Finds the cues that are called, from states of which some are left out: a cue that stood for less than a tenth
    of a second is not found."""

    def __init__(self) -> None:
        self._pressed: dict[str, float] = {}
        self._current: dict[str, str] = {}

    def calls(self, now: float, state: Shown, backs: Iterable[float] = ()) -> list[CueCall]:
        """The cues that were called since the state before. now: seconds of the machine's clock; state: as it is then;
        backs: when somebody went back, which calls no cue."""
        found: list[CueCall] = []
        gone_back = list(backs)
        for name, status in ({} if state.cues is None else state.cues.lists).items():
            pressed = -math.inf if status.since is None else now - status.since
            again = pressed > self._pressed.get(name, -math.inf) + 0.5 / CURVE_RATE**2
            followed = status.current is not None and status.current.identity != self._current.get(name, "")
            back = any(abs(pressed - at) < 0.5 / CURVE_RATE**2 for at in gone_back)
            if status.current is not None and (again or followed) and not back:
                found.append(CueCall(pressed if again else now, name, status.current.number))
            self._pressed[name] = max(pressed, self._pressed.get(name, -math.inf))
            self._current[name] = "" if status.current is None else status.current.identity
        return found


class Untitled:
    """A cast that knows the region of no channel."""

    titles: Mapping[str, Title] = MappingProxyType({})


class CurveSampler:
    """Makes curves of the states of a show, as they were sent. cast: knows the regions of channels; whoever changes the
    cast sets it."""

    def __init__(self) -> None:
        self.cast: HasTitles = Untitled()
        self._times: list[float] = []
        self._states: list[Shown] = []
        self._calls: list[CueCall] = []
        self._watch = CueWatch()

    def note(self, now: float, state: bytes, backs: Iterable[float]) -> None:
        """Notes a state. now: seconds of the machine's clock; state: as it was sent; backs: as of `CueWatch.calls`."""
        shown = _decoder.decode(state)
        self._calls += self._watch.calls(now, shown, backs)
        self._times.append(now)
        self._states.append(shown)

    def take(self) -> tuple[bytes, list[CueCall]]:
        """Returns and clears what was noted: packed curves, "" for none, and the cues that were called."""
        packed = pack_curves(sample_curves(self._times, self._states, self.cast)) if self._times else b""
        calls = self._calls
        self._times = []
        self._states = []
        self._calls = []
        return packed, calls


def join_curves(parts: Sequence[Curves]) -> Curves:
    """Curves one after the other, as one."""
    names: dict[str, int] = {}
    length = sum(len(part.times) for part in parts)
    values = {
        name: np.full((length, len(_STEPS)), np.nan) for name in dict.fromkeys(name for p in parts for name in p.values)
    }
    begin = 0
    for part in parts:
        places = np.array([names.setdefault(name, len(names)) for name in part.names], dtype=np.float64)
        for name, table in part.values.items():
            rows = table.copy()
            there = ~np.isnan(rows[:, 0])
            rows[there, len(QUANTITIES) :] = places[rows[there, len(QUANTITIES) :].astype(int)]
            values[name][begin : begin + len(rows)] = rows
        begin += len(part.times)
    times = np.concatenate([part.times for part in parts]) if parts else np.empty(0)
    return Curves(times, values, tuple(names))


class _Packed(msgspec.Struct, frozen=True, array_like=True):
    """first: seconds; times: milliseconds between samples; names; tables: of each character, steps between samples,
    column by column."""

    first: float
    times: bytes
    names: list[str]
    tables: dict[str, bytes]


def pack_curves(curves: Curves) -> bytes:
    """The bytes of curves, rounded to a thousandth of a weight, a tenth of a degree and a centimetre."""
    first = float(curves.times[0]) if len(curves.times) else 0.0
    steps = np.diff(np.rint((curves.times - first) / TIME_STEP), prepend=0.0).astype("<u4")
    tables = {name: _pack_table(table) for name, table in curves.values.items()}
    return zlib.compress(msgspec.msgpack.encode(_Packed(first, steps.tobytes(), list(curves.names), tables)), 9)


def unpack_curves(data: bytes) -> Curves:
    """The curves again; ValueError where the bytes are damaged."""
    try:
        unpacker = zlib.decompressobj()
        whole = unpacker.decompress(data, MOST_BYTES)
        if not unpacker.eof:
            raise ValueError("they end too early, or are too large")
        packed = msgspec.msgpack.decode(whole, type=_Packed)
        times = packed.first + np.cumsum(np.frombuffer(packed.times, "<u4").astype(np.float64)) * TIME_STEP
        values = {name: _unpack_table(data, len(times)) for name, data in packed.tables.items()}
    except (zlib.error, msgspec.MsgspecError, ValueError) as error:
        raise ValueError("the curves of a minute of the recording are damaged") from error
    return Curves(times, values, tuple(packed.names))


def _pack_table(table: Values) -> bytes:
    steps = np.rint(table * _STEPS)
    whole = np.where(np.isnan(steps), MISSING, steps).astype("<i2")
    whole[1:] -= whole[:-1].copy()  # wraps, and so does the sum
    return whole.T.tobytes()


def _unpack_table(data: bytes, length: int) -> Values:
    whole = np.frombuffer(data, "<i2").reshape(len(_STEPS), length).T
    steps = np.cumsum(whole, axis=0, dtype=np.int16)
    return np.where(steps == MISSING, np.nan, steps / _STEPS)
