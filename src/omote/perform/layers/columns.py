"""The columns of a character's layers: one for each channel that any layer has, then five angles; and where in one
vector each follower lies."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.expression import Expression, Title
from omote.perform.channels import GAZE_UNITS, highest_weight
from omote.perform.layers.follower import rate_of
from omote.perform.layers.layer_names import DRIVEN, LAYER_PARTS, LAYERS, WHOLE, LayerName, part_of_channel
from omote.perform.limits import CHANNEL_LOWEST, GAZE_LIMITS, HEAD_LIMITS

ANGLES = (*(f"head {name}" for name in HEAD_LIMITS), *(f"gaze {name}" for name in GAZE_LIMITS))
"""The columns behind the channels: yaw, pitch and roll of the head, yaw and pitch of the gaze."""
_ANGLE_LIMITS = [*HEAD_LIMITS.values(), *GAZE_LIMITS.values()]
HEAD = slice(-5, -2)
GAZE = slice(-2, None)
HEAD_PART = LAYER_PARTS.index("head")
GAZE_PART = LAYER_PARTS.index("gaze")

STREAM_SECONDS = 0.12
"""In which what a source sends is followed while it trembles; what moves is followed sooner, by `STREAM_HASTE`."""
MOUTH_SECONDS = 0.07
"""In which a mouth is: speech opens and closes it four to six times a second."""
LIPS_SECONDS = 0.04
"""In which the layer of speech is."""
RETURN_SECONDS = 0.2
"""In which a source is followed that has just come, or come back: what it sends then may be a jump."""
LEAST_SECONDS = 0.03
"""In which the liveliest source is followed: two ticks."""
STREAM_HASTE = 60.0
"""1/s and unit: a lid that closes in a tenth of a second is some 40 ms behind."""
HAND_SECONDS = 0.3
"""In which a fader is followed while a source plays below it; without one it is immediate."""
SHARE_SECONDS = 0.5
"""In which an influence and a switch are followed."""
HOLD_SECONDS = 0.7
"""In which the hold of a hand is: on a channel that is a unit off, it changes the speed by .14 a second in 1/240 s."""
TRUST_SECONDS = 1.0

PLACES = WHOLE + 1
"""Of an influence and of a trust: the parts, and what acts on the whole face."""

MOST_REMEMBERED = 64
"""Sequences of channels whose places are remembered: those of sources, and what hands hold as it changes."""
SECTIONS = ("streams", "hands", "hold", "share", "trust", "yielded")


@dataclass(frozen=True, eq=False)
class Pace:
    """How a source is followed, in the columns of a layer (its row) that show it: in how many seconds, 0 as its layer
    is; steady: 0 where it has just come, 1 where its frames have come without a gap for a while."""

    row: int
    own: NDArray[np.bool_]
    seconds: float
    steady: float


@dataclass(frozen=True, eq=False)
class Columns:
    """Names of channels, and all that follows from them alone. width: columns of a layer; size: followers of all
    layers; shapes: of the sections that are no rows. names: sorted; parts: of each column, its place among
    `LAYER_PARTS`, `WHOLE` for the whole face; highest: its largest value; of_face: those that move skin, not the eyes
    nor the head; eyes: the names of the units that turn the eyes."""

    names: tuple[str, ...]
    parts: NDArray[np.intp]
    highest: Values
    of_face: NDArray[np.bool_] = field(init=False)
    eyes: tuple[str, ...] = field(init=False)
    index: Mapping[str, int] = field(init=False)
    sections: Mapping[str, slice] = field(init=False)
    width: int = field(init=False)
    size: int = field(init=False)
    shapes: Mapping[str, tuple[int, int]] = field(init=False)
    rate: Values = field(init=False)
    haste: Values = field(init=False)
    lowest: Values = field(init=False)
    _in_parts: dict[tuple[bool, ...], NDArray[np.bool_]] = field(init=False, default_factory=dict)
    _places: dict[tuple[str, ...], NDArray[np.intp]] = field(init=False, default_factory=dict)
    _turns: dict[tuple[bool, bool], NDArray[np.intp]] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "width", len(self.names) + len(ANGLES))
        sizes = {"streams": len(DRIVEN) * self.width, "hands": self.width, "hold": self.width}
        sizes |= {"share": len(LAYERS) * PLACES, "trust": len(DRIVEN) * PLACES, "yielded": len(PLAY_REGIONS)}
        ends = np.cumsum([sizes[name] for name in SECTIONS]).tolist()
        sections = {name: slice(end - sizes[name], end) for name, end in zip(SECTIONS, ends, strict=True)}
        seconds = (HAND_SECONDS, HOLD_SECONDS, SHARE_SECONDS, TRUST_SECONDS, SHARE_SECONDS)
        counts = [sizes[name] for name in SECTIONS]
        streams = [rate_of(seconds) for layer in DRIVEN for seconds in _stream_seconds(layer, self.parts)]
        derived = {
            "of_face": (self.parts < len(PLAY_REGIONS)) | (self.parts == WHOLE),
            "eyes": tuple(unit for unit in GAZE_UNITS if unit in self.names),
            "index": {name: place for place, name in enumerate(self.names)},
            "sections": sections,
            "size": ends[-1],
            "shapes": {
                "streams": (len(DRIVEN), self.width),
                "share": (len(LAYERS), PLACES),
                "trust": (len(DRIVEN), PLACES),
            },
            "rate": np.concatenate([streams, np.repeat([rate_of(length) for length in seconds], counts[1:])]),
            "haste": np.repeat([STREAM_HASTE, 0.0, 0.0, 0.0, 0.0, 0.0], counts),
            "lowest": np.concatenate([np.full(len(self.names), CHANNEL_LOWEST), -self.highest[len(self.names) :]]),
        }
        for name, value in derived.items():
            object.__setattr__(self, name, value)

    def rows(self, vector: Values, section: str) -> Values:
        """A section of a vector of all followers: (6, width) streams, (8, 7) shares, (6, 7) trusts, else
        flat; a view."""
        flat = vector[self.sections[section]]
        return flat.reshape(self.shapes[section]) if section in self.shapes else flat

    def stream_rates(self, paces: Sequence[Pace]) -> tuple[Values, Values]:
        """The rate and the haste of all followers where some streams are followed otherwise than their layers."""
        if not paces:
            return self.rate, self.haste
        rate = self.rate.copy()
        haste = self.haste.copy()
        slow = rate_of(RETURN_SECONDS)
        for pace in paces:
            row = self.rows(rate, "streams")[pace.row]
            hastes = self.rows(haste, "streams")[pace.row]
            if pace.seconds:
                row[pace.own] = rate_of(max(pace.seconds, LEAST_SECONDS))
                hastes[pace.own] *= min(RETURN_SECONDS / pace.seconds, 1.0)
            near = np.minimum(row[pace.own], slow)
            row[pace.own] = near + pace.steady * (row[pace.own] - near)
        return rate, haste

    def in_parts(self, parts: tuple[bool, ...]) -> NDArray[np.bool_]:
        """Whether each column is of these parts, given as one switch for each and one for the whole face."""
        columns = self._in_parts.get(parts)
        if columns is None:
            columns = self._in_parts[parts] = np.array(parts)[self.parts]
        return columns

    def places(self, names: tuple[str, ...]) -> NDArray[np.intp]:
        """The columns of some channels."""
        columns = self._places.get(names)
        if columns is None:
            if len(self._places) >= MOST_REMEMBERED:
                self._places.clear()
            columns = self._places[names] = np.array([self.index[name] for name in names], np.intp)
        return columns

    def places_of_turns(self, head: bool, gaze: bool) -> NDArray[np.intp]:
        """The columns of what a frame turns: of a head yaw, pitch and roll, of a gaze yaw, pitch and `eyes`."""
        columns = self._turns.get((head, gaze))
        if columns is None:
            of_head = range(self.width + HEAD.start, self.width + HEAD.stop) if head else ()
            of_gaze = [*range(self.width + GAZE.start, self.width), *(self.index[eye] for eye in self.eyes)]
            columns = self._turns[head, gaze] = np.array([*of_head, *(of_gaze if gaze else ())], np.intp)
        return columns


class HasExpressions(Protocol):
    """What is played: a cast, or any expressions by name. Titles say to which part each belongs."""

    @property
    def expressions(self) -> Mapping[str, Expression]:
        """The expressions."""

    @property
    def titles(self) -> Mapping[str, Title]:
        """Where expressions act; one without a title acts on the whole face."""


def make_columns(cast: HasExpressions, names: Iterable[str]) -> Columns:
    """The columns of these channels, as far as the cast has them, and of the units that turn the eyes.

    names: of the channels.
    """
    in_cast = {name for name in names if name in cast.expressions}
    return columns_of(cast, tuple(sorted(in_cast | {unit for unit in GAZE_UNITS if unit in cast.expressions})))


def columns_of(cast: HasExpressions, wanted: tuple[str, ...]) -> Columns:
    """The columns of exactly these channels; by the regions of the cast's titles. wanted: their names."""
    parts = [_part(cast.titles, name) for name in wanted] + [HEAD_PART] * 3 + [GAZE_PART] * 2
    highest = [highest_weight(cast.expressions, name) for name in wanted]
    return Columns(wanted, np.array(parts, np.intp), np.array(highest + _ANGLE_LIMITS))


def _stream_seconds(layer: LayerName, parts: NDArray[np.intp]) -> list[float]:
    """In how many seconds each column of a layer is followed."""
    if layer == "lips":
        return [LIPS_SECONDS] * len(parts)
    mouth = LAYER_PARTS.index("mouth")
    return [MOUTH_SECONDS if part == mouth else STREAM_SECONDS for part in parts.tolist()]


def _part(titles: Mapping[str, Title], name: str) -> int:
    if name in GAZE_UNITS:
        return GAZE_PART
    return part_of_channel(titles[name].region) if name in titles else WHOLE


def moved_to(vector: Values, old: Columns, new: Columns) -> Values:
    """A vector of all followers under other columns: what is new is at rest, and all in range.

    old: the columns that it has.
    """
    later = np.zeros(new.size)
    kept = tuple(name for name in old.names if name in new.index)
    before = _with_angles(old, kept)
    after = _with_angles(new, kept)
    new.rows(later, "streams")[:, after] = old.rows(vector, "streams")[:, before]
    for section in ("hands", "hold"):
        new.rows(later, section)[after] = old.rows(vector, section)[before]
    count = len(new.names)
    for section in ("streams", "hands"):  # another cast may turn the eyes farther by less
        rows = new.rows(later, section)[..., :count]
        np.clip(rows, new.lowest[:count], new.highest[:count], out=rows)
    for section in ("share", "trust", "yielded"):
        later[new.sections[section]] = vector[old.sections[section]]
    return later


def _with_angles(columns: Columns, names: tuple[str, ...]) -> NDArray[np.intp]:
    angles = np.arange(len(columns.names), columns.width, dtype=np.intp)
    return np.concatenate([columns.places(names), angles])
