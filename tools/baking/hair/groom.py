"""Grows, combs and cuts hair strands on the scalp of the generic head: the groom of every style."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from tools.baking.hair.coil import Coil, Tail
from tools.baking.hair.growth_field import Field
from tools.baking.heads.basemesh import Floats, Ints

STATIONS = 12  # places along a strand, root to tip
STRIDE = 0.0025  # metres a strand grows at a time
AXIS = np.array([0.0, 0.0, 0.03])  # hairlines are told by the angle around it
CANDIDATES = 8000  # places on the scalp from which the roots are chosen
LOCK = 7  # strands in a lock
APART = 0.04  # metres from its lock's leader beyond which a strand goes its own way
SUNK = 0.001  # metres that a root lies under the skin
LEAN = 0.5  # of the way from straight out of the skin to where it is combed, that a hair grows at first
FLAT = 0.12  # of its height over the skin, that hair has which grows at its edge
INWARD = 0.024  # metres within the edge, from where on hair lies as high as the style says
FINEST = 0.2  # of its width, that hair has at the hairline's edge
DOWNY = (0.006, 0.014)  # metres: how long the finest hair at the edge grows

Angles = Sequence[tuple[float, float]]


@dataclass(frozen=True, eq=False)
class Strands:
    """Strands while they grow: where they are now, where they began, how long they are, and each one's own chances.

    points, roots (n, 3) metres; grown (n,) metres; chance (n, 4) in 0..1: layer, direction, length, anything
    """

    points: Floats
    roots: Floats
    grown: Floats
    chance: Floats


Comb = Callable[[Strands], Floats]
Cut = Callable[[Strands], NDArray[np.bool_]]


@dataclass(frozen=True, eq=False)
class Groom:
    """A style as a recipe.

    hairline: (angle from straight ahead, metres over the eyes) pairs, hair grows above;  comb: where strands want to go
    (n, 3);  cut: which strands end here (n,);  layers: metres over the skin of the innermost and the outermost strands;
    hold: 1 it lies on the head, 0 it stands off;  free: it hangs free below this height;  width: of a
    ribbon, metres;  wave: amplitude (metres) and length (metres) of curls;  closing, blur: see `field_of`;  bound:
    buns and tails beside what grows;  locks: how much neighbours are alike, 0..1;  bald: nothing grows above this
    height, metres;  scalp: the shade of hair on the skin that goes with it, 0..1;  sparse: metres within its edges in
    which hair grows ever finer
    """

    hairline: Angles
    comb: Comb
    cut: Cut
    count: int = 900
    length: float = 0.25
    layers: tuple[float, float] = (0.003, 0.012)
    rise: float = 0.03
    hold: float = 0.85
    free: float = -0.02
    stiffness: float = 0.6
    width: float = 0.006
    wave: tuple[float, float] = (0.0008, 0.03)
    closing: float = 0.012
    blur: float = 0.004
    bound: tuple[Coil | Tail, ...] = ()
    locks: float = 0.6
    bald: float = np.inf
    scalp: float = 1.0
    sparse: float = 0.009
    seed: int = 1


def above(line: Angles, points: Floats) -> Floats:
    """Metres by which points (n, 3) lie above a hairline, (n,).

    line: heights of the hairline by angle around the head.
    """
    angle = np.abs(np.arctan2(points[:, 0] - AXIS[0], points[:, 2] - AXIS[2]))
    return np.asarray(points[:, 1] - np.interp(angle, [at for at, _ in line], [height for _, height in line]))


def within(groom: Groom, points: Floats) -> Floats:
    """Metres by which points (n, 3) lie within the edges of a style's hair, (n,); negative beyond them."""
    return np.minimum(above(groom.hairline, points), groom.bald - points[:, 1])


def fullness_of(groom: Groom, roots: Floats) -> Floats:
    """How thick hair is at its roots (n, 3), of the style's width, 0..1 each, (n,): finest at its edges."""
    return FINEST + (1.0 - FINEST) * _ease(within(groom, roots) / groom.sparse)


def flatness_of(groom: Groom, roots: Floats) -> Floats:
    """How high hair with these roots (n, 3) lies over the skin, of its height farther in, 0..1 each, (n,)."""
    return FLAT + (1.0 - FLAT) * _ease(within(groom, roots) / INWARD)


def roots_of(groom: Groom, points: Floats, triangles: Ints) -> Floats:
    """Where a style's hair grows (n, 3): spread evenly, so that the first few of them already cover the scalp.

    groom: the style; points (V, 3), triangles (t, 3): of the skin, metres.
    """
    rng = np.random.default_rng(groom.seed)
    corners = points[triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    area = area * (within(groom, corners.mean(axis=1)) > -0.01)
    chosen = rng.choice(len(triangles), CANDIDATES, p=area / area.sum())
    weights = rng.dirichlet((1.0, 1.0, 1.0), CANDIDATES)
    places = np.einsum("nc,ncd->nd", weights, corners[chosen])
    ear = (np.abs(places[:, 0]) > 0.0705) & (places[:, 1] < 0.024) & (places[:, 2] < 0.064)
    ragged = rng.normal(0.0, 0.0015, CANDIDATES)
    return _pick_spread(places[(within(groom, places) > ragged) & ~ear], groom.count)


def _pick_spread(places: Floats, count: int) -> Floats:
    """`count` of the places, each the farthest from all before it."""
    far = np.full(len(places), np.inf)
    chosen = [int(places[:, 1].argmax())]
    for _ in range(count - 1):
        far = np.minimum(far, ((places - places[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(far.argmax()))
    return np.asarray(places[chosen])


def grow(groom: Groom, field: Field, roots: Floats) -> Floats:
    """The strands (n, STATIONS, 3) of a style, from under the skin to their tips.

    groom: the style; field: around the skin; roots (n, 3): metres.
    """
    chance = _alike(groom, roots, np.random.default_rng(groom.seed + 1).uniform(size=(len(roots), 4)))
    outward = field.outward(roots)
    points = roots - SUNK * outward
    combed = _unit(groom.comb(Strands(points, roots, np.zeros(len(roots)), chance)))
    heading = _unit(
        outward + LEAN * (combed - np.minimum((combed * outward).sum(axis=1), 0.0)[:, None] * outward - outward)
    )
    course = [points]
    ends = np.full(len(roots), -1)
    downy = _downy(groom, roots, chance[:, 3])
    for step in range(round(groom.length / STRIDE)):
        strands = Strands(points, roots, np.full(len(roots), step * STRIDE), chance)
        done = (groom.cut(strands) | (strands.grown > downy)) if step > 2 else np.zeros(len(roots), bool)
        ends = np.where((ends < 0) & done, step, ends)
        heading = _heading(groom, field, strands, heading)
        points = points + STRIDE * heading
        course.append(points)
    ends = np.where(ends < 0, len(course) - 1, ends)
    return _gather(groom, _add_waves(groom, field, _stations(np.stack(course, axis=1), ends), chance))


def _downy(groom: Groom, roots: Floats, chance: Floats) -> Floats:
    """Metres after which strands end because they are down at the hairline's edge, (n,); infinite farther in."""
    edge = 1.0 - _ease((within(groom, roots) - 0.001) / (0.5 * groom.sparse))
    low, high = DOWNY
    return np.where(chance < edge, low + (high - low) * (chance / np.maximum(edge, 1e-9)), np.inf)


def _leaders(roots: Floats) -> Ints:
    """The strand that leads each strand's lock, (n,): the first ones are spread evenly."""
    _, leader = cKDTree(roots[: max(1, len(roots) // LOCK)]).query(roots)
    return np.asarray(leader)


def _alike(groom: Groom, roots: Floats, chance: Floats) -> Floats:
    """The strands' chances (n, 4), those of a lock alike in all but the layer."""
    share = groom.locks * np.array([0.0, 1.0, 1.0, 1.0])
    return np.asarray(chance + share * (chance[_leaders(roots)] - chance))


def _gather(groom: Groom, strands: Floats) -> Floats:
    """Strands (n, STATIONS, 3) drawn toward their lock's leader where it is near, the more the nearer the tip."""
    toward = strands[_leaders(strands[:, 0])] - strands
    near = 1.0 - _ease(np.linalg.norm(toward, axis=2).max(axis=1) / APART)
    share = 0.6 * groom.locks * near[:, None] * _ease(np.linspace(0.0, 1.0, STATIONS))
    return np.asarray(strands + share[..., None] * toward)


def _heading(groom: Groom, field: Field, strands: Strands, before: Floats) -> Floats:
    """Unit vectors (n, 3): combed along the head, lifted to the strand's own layer, a little as before."""
    height = field.height(strands.points)
    out = field.outward(strands.points)
    wanted = _unit(groom.comb(strands))
    low, high = groom.layers
    layer = (low + (high - low) * strands.chance[:, 0]) * _ease(strands.grown / groom.rise)
    layer *= flatness_of(groom, strands.roots)  # else roots are stems at the edge
    near = 1.0 - _ease((height - layer) / 0.02)
    hold = groom.hold * _ease((strands.points[:, 1] - groom.free) / 0.03)
    into = (wanted * out).sum(axis=1)
    along = wanted - np.where(into < 0.0, near * into, hold * into)[:, None] * out
    lift = np.clip((layer - height) / 0.006, -hold, 1.2)
    heading = _unit(_unit(along) + lift[:, None] * out)
    stiff = groom.stiffness * (0.5 + 0.5 * _ease(strands.grown / 0.02))
    return _unit(stiff[:, None] * before + (1.0 - stiff)[:, None] * heading)


def _stations(course: Floats, ends: Ints) -> Floats:
    """Each strand's course (n, steps, 3) up to its end as STATIONS places, closer together near the root."""
    share = np.linspace(0.0, 1.0, STATIONS) ** 1.2
    places = share[None] * ends[:, None]
    first = np.minimum(places.astype(int), course.shape[1] - 2)
    part = (places - first)[..., None]
    rows = np.arange(len(course))[:, None]
    return np.asarray(course[rows, first] * (1.0 - part) + course[rows, first + 1] * part)


def _add_waves(groom: Groom, field: Field, strands: Floats, chance: Floats) -> Floats:
    """Strands with their waves, which grow from nothing at the root."""
    amplitude, length = groom.wave
    steps = np.linalg.norm(np.diff(strands, axis=1), axis=2)
    grown = np.concatenate([np.zeros((len(strands), 1)), steps.cumsum(axis=1)], axis=1)
    out = field.outward(strands)
    aside = _unit(np.cross(np.gradient(strands, axis=1), out))
    phase = 2 * np.pi * (grown / (length * (0.75 + 0.5 * chance[:, 2:3])) + chance[:, 3:4])
    size = amplitude * _ease(grown / 0.03) * (0.4 + 1.2 * chance[:, 1:2])
    return np.asarray(strands + size[..., None] * (np.sin(phase)[..., None] * aside + np.cos(phase)[..., None] * out))


def _unit(vectors: Floats) -> Floats:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9))


def _ease(share: Floats) -> Floats:
    x = np.clip(share, 0.0, 1.0)
    return np.asarray(x * x * (3.0 - 2.0 * x))
