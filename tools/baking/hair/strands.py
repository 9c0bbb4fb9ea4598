"""Bakes the hair styles: strands grown on the generic head and bound to its skin."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree

from omote.arrays import Indices, Mask, Values
from omote.model.hair import LINKS, HairStyle
from omote.model.space.parameter_space import ParameterSpace
from tools.baking.assemble import Arrays, Step
from tools.baking.hair.groom import STATIONS, Groom, flatness_of, fullness_of, grow, roots_of
from tools.baking.hair.growth_field import Field, field_of, surface_samples
from tools.baking.hair.styles import GROOMS
from tools.baking.heads.basemesh import Floats, Ints

CLEARANCE = 0.002  # metres between skin and strand, from the third place on, where hair is as high as its style says
BURIED = 0.02  # metres beyond which a place is no matter of the skin nearest to it
ROUNDS = 4
SHARES = 255  # parts that weights are counted in: what a page reads, and a cast that packs well
CELL = 0.004  # metres, of the grid on which hair shades hair
DEEPEST = 0.1  # light that comes through any hair
DEPTH = 0.012  # metres of hair over a place that take most of its light


def hair_arrays(space: ParameterSpace, step: Step) -> Arrays:
    """Every style as `hair/STYLE/...` (omote.builtin.castfile).

    space: of the generic face; step: is called with the name of each style.
    """
    arrays: Arrays = {}
    for name, groom in GROOMS.items():
        style = grow_style(name, groom, space)
        for what in ("points", "rows", "weights", "anchors", "facing", "light", "fullness"):
            arrays[f"hair/{name}/{what}"] = getattr(style, what)
        for what in ("width", "scalp"):
            arrays[f"hair/{name}/{what}"] = np.array(getattr(style, what), np.float32)
        step(f"hair {name}")
    return arrays


def grow_style(name: str, groom: Groom, space: ParameterSpace) -> HairStyle:
    """A style on the generic head of a space.

    name: of the style; groom: how it grows.
    """
    skin = space.points
    triangles = space.triangles
    field = field_of(skin, triangles, closing=groom.closing, blur=groom.blur)
    roots = roots_of(groom, skin, triangles)
    strands, fullness, flatness = _all_strands(groom, field, roots)
    points = np.round(push_out(strands, skin, triangles, CLEARANCE * flatness), 5) + 0.0
    rows, weights = find_anchors(points, skin, space.on_sheet)
    anchors = rows[:, 0, 0]
    return HairStyle(
        name=name,
        points=points.astype(np.float32),
        rows=rows,
        weights=_counted(weights),
        anchors=anchors,
        facing=np.round(field.outward(points), 3).astype(np.float32),
        light=np.round(open_sky(field, points), 3).astype(np.float32),
        fullness=np.round(fullness, 3).astype(np.float32),
        width=groom.width,
        scalp=groom.scalp,
    )


def _all_strands(groom: Groom, field: Field, roots: Floats) -> tuple[Floats, Floats, Floats]:
    """What grows, and what is bound, evenly among it, and how thick and how high each strand is: the first few of all
    strands show the whole style."""
    grown = grow(groom, field, roots)
    own = np.stack([fullness_of(groom, roots), flatness_of(groom, roots)])
    if not groom.bound:
        return grown, *own
    bound = np.concatenate(
        [
            one.wind(field.outward(one.foot[None])[0], STATIONS, seed=groom.seed + at)
            for at, one in enumerate(groom.bound)
        ]
    )
    bound = bound[np.random.default_rng(groom.seed).permutation(len(bound))]
    place = np.linspace(0, len(grown), len(bound), endpoint=False).astype(int)
    return np.insert(grown, place, bound, axis=0), *np.insert(own, place, 1.0, axis=1)


def find_anchors(points: Values, skin: Values, allowed: Mask, /) -> tuple[Indices, Values]:
    """Finds the skin's vertices (..., LINKS) that carry points (..., 3), and their weights, which sum to one
    (skinning).

    skin (V, 3) metres; allowed (V,): the vertices that may. Weights fall to zero at the first vertex that is left out
    (Franke and Little 1980), so that neighbours on a strand are carried alike.
    """
    usable = np.flatnonzero(allowed)
    far, found = cKDTree(skin[usable]).query(points, k=LINKS + 1)
    near = np.maximum(far[..., :LINKS], 1e-6)
    limit = far[..., LINKS:] * (1.0 + 1e-6)
    weights = ((limit - near) / (limit * near)) ** 2
    return usable[found[..., :LINKS]].astype(np.int32), weights / weights.sum(axis=-1, keepdims=True)


def _counted(weights: Values) -> NDArray[np.float32]:
    """Weights (n, k, LINKS) as whole numbers of `SHARES` that sum to one, each the nearest but for the largest."""
    counts = np.rint(SHARES * weights)
    largest = weights.argmax(axis=-1)[..., None]
    rest = SHARES - counts.sum(axis=-1, keepdims=True)
    np.put_along_axis(counts, largest, np.take_along_axis(counts, largest, axis=-1) + rest, axis=-1)
    return (counts / SHARES).astype(np.float32)


def push_out(points: Floats, skin: Floats, triangles: Ints, clearance: Floats) -> Floats:
    """Strands (n, k, 3) pushed out of the skin: the field they grew on is smoother than ears are.

    points (n, k, 3): metres; skin (V, 3), triangles (t, 3); clearance (n,): metres between the skin and each strand.
    """
    spots, facing = surface_samples(skin, triangles)
    tree = cKDTree(spots)
    wanted = clearance[:, None] * np.minimum(np.arange(points.shape[1]) / 2.0, 1.0)
    for _ in range(ROUNDS):
        far, nearest = tree.query(points)
        height = ((points - spots[nearest]) * facing[nearest]).sum(axis=-1)
        push = np.where(far < BURIED, np.maximum(wanted - height, 0.0), 0.0)
        push[:, 2:-1] = np.maximum(push, ndimage.uniform_filter1d(push, 3, axis=1))[:, 2:-1]  # no kink beside an ear
        push[:, 0] = 0.0
        points = points + push[..., None] * facing[nearest]
    return points


def open_sky(field: Field, points: Floats) -> Floats:
    """How much light comes through the hair above each place (n, k), 0..1.

    field: around the skin; points (n, k, 3): metres.
    """
    places = np.moveaxis((points - field.origin) / CELL, -1, 0)
    shape = tuple(int(places[axis].max()) + 8 for axis in range(3))
    hair = np.zeros(shape)
    np.add.at(hair, tuple(places.astype(int)), np.linalg.norm(np.gradient(points, axis=1), axis=-1))
    hair = ndimage.gaussian_filter(hair, 1.5)
    hair /= np.percentile(hair[hair > 1e-4 * hair.max()], 75)
    above = np.zeros(points.shape[:2])
    for far in np.arange(1, 5) * DEPTH / 4:
        spots = np.moveaxis((points + far * field.outward(points) - field.origin) / CELL, -1, 0)
        above += ndimage.map_coordinates(hair, spots, order=1, mode="constant") / 4
    return np.asarray(DEEPEST + (1.0 - DEEPEST) * np.exp(-0.8 * above))
