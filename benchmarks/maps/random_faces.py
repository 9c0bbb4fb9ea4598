"""Faces that nobody tuned on: people of the package's own sliders, strong ones, caricatures and regional mixes.

People come from the pinned CC0 package that the cast is baked from, with sliders and shapes drawn at random, and are
put in order as the bake does (throat, lips, mouth bag, sockets). Whose face it is depends on the seed alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import omote
from omote.builtin.binding import PARTS
from omote.model.cast import Cast
from omote.model.sculpting.socket_depth import fit_lining_at_rest
from omote.model.space.face import Face
from omote.model.space.head_regions import REGIONS
from omote.model.transfer.mouth_at_rest import fit_mouth_at_rest
from tools.baking.heads.basemesh import BaseMesh, read_base_mesh
from tools.baking.heads.head import Head, cut_head
from tools.baking.heads.neck import level_throat
from tools.baking.heads.person import Build, Person, person_points
from tools.baking.package import Package, find_wheel

CACHE = Path(__file__).resolve().parents[2] / "build" / "cast"
PEOPLE = "people"
STRONG = "strong"
CARICATURES = "caricatures"
MIXES = "mixes"
COUNTS: Mapping[str, int] = {PEOPLE: 30, STRONG: 10, CARICATURES: 10, MIXES: 10}
HUMANS = ("kaori", "round", "child", "baby", "old", "man", "gaunt", "heavy", "auntie")
AMOUNTS = (1.2, 2.0)
"""Of caricature, from and to."""

# MakeHuman's shapes for parts of the head, in opposite pairs; `*` is both sides. The neck's belong to a body.
SHAPES: Sequence[tuple[str, ...]] = tuple(
    tuple(f"{folder}/{name}-{end}" for end in ends)
    for folder, ends, names in (
        ("cheek", ("decr", "incr"), ("*-cheek-bones", "*-cheek-inner", "*-cheek-volume")),
        ("cheek", ("down", "up"), ("*-cheek-trans",)),
        ("chin", ("decr", "incr"), ("chin-bones", "chin-cleft", "chin-height", "chin-jaw-drop", "chin-prognathism",
                                    "chin-prominent", "chin-width")),
        ("eyebrows", ("down", "up"), ("eyebrows-angle", "eyebrows-trans")),
        ("eyes", ("decr", "incr"), ("*-eye-bag", "*-eye-height1", "*-eye-height2", "*-eye-height3", "*-eye-scale")),
        ("eyes", ("down", "up"), ("*-eye-corner1", "*-eye-corner2", "*-eye-eyefold", "*-eye-eyefold-angle",
                                  "*-eye-trans")),
        ("eyes", ("in", "out"), ("*-eye-epicanthus", "*-eye-push1", "*-eye-push2", "*-eye-trans")),
        ("forehead", ("decr", "incr"), ("forehead-nubian", "forehead-scale-vert", "forehead-temple")),
        ("head", ("decr", "incr"), ("head-fat", "head-scale-depth", "head-scale-horiz", "head-scale-vert")),
        ("mouth", ("decr", "incr"), ("mouth-cupidsbow", "mouth-lowerlip-height", "mouth-lowerlip-volume",
                                     "mouth-lowerlip-width", "mouth-philtrum-volume", "mouth-scale-depth",
                                     "mouth-scale-horiz", "mouth-scale-vert", "mouth-upperlip-height",
                                     "mouth-upperlip-volume", "mouth-upperlip-width")),
        ("mouth", ("down", "up"), ("mouth-angles", "mouth-lowerlip-ext", "mouth-lowerlip-middle", "mouth-trans",
                                   "mouth-upperlip-ext", "mouth-upperlip-middle")),
        ("nose", ("decr", "incr"), ("nose-flaring", "nose-greek", "nose-hump", "nose-nostrils-width",
                                    "nose-point-width", "nose-scale-depth", "nose-scale-horiz", "nose-scale-vert",
                                    "nose-septumangle", "nose-volume", "nose-width1", "nose-width2", "nose-width3")),
        ("nose", ("down", "up"), ("nose-base", "nose-nostrils-angle", "nose-point", "nose-trans")),
    )
    for name in names
)  # fmt: skip
WHOLE = ("diamond", "invertedtriangular", "oval", "rectangular", "round", "square", "triangular")
RACES = ("african", "asian", "caucasian")


@dataclass(frozen=True)
class Setting:
    """How people are drawn: how many shapes of parts, and the most of each, of head shapes, and by how much sizes
    differ."""

    shapes: int
    most: float
    head: float
    size: float


ORDINARY = Setting(14, 0.6, 0.5, 0.05)
EXTREME = Setting(26, 1.1, 1.0, 0.1)


class PeopleMaker:
    """Makes people of the cast's space from the package."""

    def __init__(self, cast: Cast) -> None:
        self._cast = cast
        self._package = Package(find_wheel(CACHE))
        self._base: BaseMesh = read_base_mesh(self._package.text("mpfb2/3dobjs/base.obj"))
        self.head: Head = cut_head(self._base)
        self.count = len(self._base.points)

    def read_unit(self, origin: str, unit: str) -> str:
        """The text of a unit's target as made for an origin."""
        return self._package.text(f"mpfb2/targets/expression/units/{origin}/{unit}.target.gz")

    def make(self, name: str, person: Person) -> Face:
        """The face of a person, put in order as the bake does."""
        head = self.head
        points = head.metres(person_points(person, self._package, self._base, head))
        generic = head.metres(self._base.points)[head.skin.vertices]
        skin = level_throat(points[head.skin.vertices], generic, head.skin.triangles)
        parts = {part: points[head.parts[part].vertices].astype(np.float32) for part in PARTS}
        space = self._cast.space
        mouth = fit_mouth_at_rest(space, skin.astype(np.float32), parts)
        return Face(name, fit_lining_at_rest(space, mouth), parts)


def draw_person(draw: np.random.Generator, setting: Setting) -> Person:
    """Sliders and shapes of somebody."""
    shape: dict[str, float] = {f"head/head-{draw.choice(WHOLE)}": draw.uniform(0.0, setting.head)}
    for row in draw.choice(len(SHAPES), setting.shapes, replace=False):
        shape[str(draw.choice(SHAPES[row]))] = draw.uniform(0.0, setting.most)
    shares = draw.dirichlet(np.full(len(RACES), 0.7))
    build = Build(
        gender=draw.uniform(), age=draw.uniform(0.15, 1.0), muscle=draw.uniform(0.1, 0.9),
        weight=draw.uniform(0.1, 0.9), race=dict(zip(RACES, shares.tolist(), strict=True)),
    )  # fmt: skip
    return Person(look={}, build=build, shape=shape, size=draw.uniform(1.0 - setting.size, 1.0 + setting.size))


def draw_faces(cast: Cast, seed: int, counts: Mapping[str, int] = COUNTS) -> dict[str, list[Face]]:
    """New faces by kind: as many as counted; the same for the same seed."""
    maker = PeopleMaker(cast)
    found: dict[str, list[Face]] = {kind: [] for kind in counts}
    for kind, setting in ((PEOPLE, ORDINARY), (STRONG, EXTREME)):
        for number in range(counts.get(kind, 0)):
            draw = np.random.default_rng([seed, list(COUNTS).index(kind), number])
            found[kind].append(maker.make(f"{kind} {number}", draw_person(draw, setting)))
    for number in range(counts.get(CARICATURES, 0)):
        found[CARICATURES].append(_caricature(cast, maker, np.random.default_rng([seed, 2, number]), number))
    for number in range(counts.get(MIXES, 0)):
        found[MIXES].append(_mix(cast, maker, np.random.default_rng([seed, 3, number]), number))
    return found


def _caricature(cast: Cast, maker: PeopleMaker, draw: np.random.Generator, number: int) -> Face:
    """Of somebody of the cast, or of a new person, by turns."""
    amount = draw.uniform(*AMOUNTS)
    drawn = cast.faces[str(draw.choice(HUMANS))] if number % 2 else maker.make("new", draw_person(draw, ORDINARY))
    face = omote.caricature(cast.space, drawn, amount)
    return Face(f"{CARICATURES} {number}: {face.name}", face.positions, face.parts)


def _mix(cast: Cast, maker: PeopleMaker, draw: np.random.Generator, number: int) -> Face:
    """Two or three regions from others of the cast, the rest from a new person."""
    regions = draw.choice(REGIONS, draw.integers(2, 4), replace=False)
    others = {str(region): cast.faces[str(draw.choice(HUMANS))] for region in regions}
    name = f"{MIXES} {number}: " + ", ".join(f"{region} {face.name}" for region, face in others.items())
    return omote.regional(cast.space, name, others, rest=maker.make("new", draw_person(draw, ORDINARY)))  # type: ignore[arg-type]
