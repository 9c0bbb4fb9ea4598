"""Spoiled inputs by the hundred: heads in any state, about any axes, in any unit, and things that are no head."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from benchmarks.maps.random_faces import PeopleMaker
from benchmarks.scans import true_heads
from benchmarks.scans.spoils import BODY_SPOILS, SPOILS, behead, pair, retriangulate, shuffle
from benchmarks.scans.strange_shapes import SHAPES
from benchmarks.scans.true_heads import ANIMALS, TrueHead
from omote.model.cast import Cast
from omote.model.fitting.landmarks import SEVEN
from omote.model.fitting.scan import Scan

Values = NDArray[np.float64]

UNITS: Mapping[str, float] = {"mm": 0.001, "cm": 0.01, "dm": 0.1, "m": 1.0, "inch": 0.0254}
"""Metres of each."""
# Clicks are off by so many metres.
CLICK = 0.003
CAST = ("kaori", "round", "child", "old", "man", "gaunt", "heavy", "baby")
SCULPTED = ("doll", "goblin", "alien", "auntie", "cat", "count", "dog", "noh")


@dataclass(frozen=True, eq=False)
class Spoiled:
    """One input: its kind, whose head, the scan, the head's place in it where it is known, and clicks.

    upright (3, 3): turns the scan as the head stands; unit: metres of one of the scan's; marks: landmarks in the scan.
    """

    kind: str
    name: str
    scan: Scan
    upright: Values | None = None
    unit: float = 1.0
    marks: Mapping[str, Values] | None = None


def draw_inputs(cast: Cast, count: int, seed: int, *, kinds: Sequence[str] = ()) -> Iterator[Spoiled]:
    """So many inputs of some kinds, or of all, by turns; the same for the same seed."""
    maker = PeopleMaker(cast)
    kinds = kinds or all_kinds()
    for number in range(count):
        draw = np.random.default_rng([seed, number])
        yield _make(cast, maker, kinds[number % len(kinds)], number // len(kinds), draw)


def all_kinds() -> list[str]:
    """What there is of inputs, by name."""
    strange = ["headless body", "two heads", *SHAPES]
    return [*SPOILS, *BODY_SPOILS, "sculpted", "animal", *strange]


def _make(cast: Cast, maker: PeopleMaker, kind: str, turn: int, draw: np.random.Generator) -> Spoiled:
    if kind in SHAPES:
        points, triangles = SHAPES[kind](draw)
        return _place(kind, TrueHead(kind, points, triangles, {}), draw, known=False)
    if kind == "headless body":
        return _place(kind, behead(true_heads.random_body(cast, maker, draw)), draw, known=False)
    if kind == "two heads":
        one, other = (_draw_head(cast, maker, turn + more, draw) for more in (0, 1))
        return _place(kind, shuffle(pair(one, other, draw), draw), draw, known=False)
    if kind == "animal":
        return _place(kind, true_heads.animal([*ANIMALS][turn % len(ANIMALS)]), draw, known=False)
    if kind == "sculpted":
        return _place(kind, retriangulate(true_heads.cast_head(cast, str(draw.choice(SCULPTED))), draw), draw)
    if kind in BODY_SPOILS:
        body = retriangulate(true_heads.random_body(cast, maker, draw), draw)
        return _place(kind, BODY_SPOILS[kind](body, draw), draw)
    head = retriangulate(_draw_head(cast, maker, turn, draw), draw)
    return _place(kind, SPOILS[kind](head, draw), draw)


def _draw_head(cast: Cast, maker: PeopleMaker, turn: int, draw: np.random.Generator) -> TrueHead:
    match (turn + int(draw.integers(2))) % 5:
        case 0 | 1:
            return true_heads.ict_person(draw)
        case 2 | 3:
            return true_heads.random_person(cast, maker, draw)
    return true_heads.perry_smith() if draw.uniform() < 0.4 else true_heads.cast_head(cast, str(draw.choice(CAST)))


def _place(kind: str, head: TrueHead, draw: np.random.Generator, *, known: bool = True) -> Spoiled:
    """The head about other axes, in another unit, somewhere else."""
    turn = _axes(draw) if draw.uniform() < 0.5 else _rotation(draw)
    unit = UNITS[str(draw.choice([*UNITS]))] if draw.uniform() < 0.8 else float(np.exp(draw.uniform(-7, 2)))
    shift = draw.normal(0, 0.5, 3) / unit
    points = head.points @ turn.T / unit + shift
    scan = Scan(points, head.triangles if len(head.triangles) else None)
    marks = {name: turn @ place / unit + shift for name, place in head.landmarks.items()}
    return Spoiled(kind, head.name, scan, turn.T if known else None, unit, marks or None)


def click(given: Spoiled, draw: np.random.Generator) -> dict[str, Values]:
    """The seven landmarks as somebody clicks them."""
    marks = given.marks or {}
    eyes = np.linalg.norm(marks["left_eye_outer"] - marks["right_eye_outer"])
    # The corners of a person's eyes are 9 cm apart.
    return {name: marks[name] + draw.normal(0, CLICK * eyes / 0.09 / np.sqrt(3), 3) for name in SEVEN}


def _axes(draw: np.random.Generator) -> Values:
    """One of the 24 ways to name axes."""
    every = [np.eye(3)[list(order)] * signs for order in permutations(range(3)) for signs in product((1, -1), repeat=3)]
    proper = [axes for axes in every if np.linalg.det(axes) > 0]
    return np.array(proper[draw.integers(len(proper))])


def _rotation(draw: np.random.Generator) -> Values:
    turn, _ = np.linalg.qr(draw.normal(size=(3, 3)))
    return np.array(turn * np.sign(np.linalg.det(turn)))
