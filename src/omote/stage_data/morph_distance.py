"""How far apart two faces are, in millimetres of mesh or in CIELAB of their pictures, and steps that are even in it.

A morph is even in millimetres by construction: a mix of faces is a sum of their positions, at rest and in any one
expression. What a picture shows of it follows light, skin and hair, so steps that are even there are found by drawing.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from omote.arrays import Picture, Values
from omote.model.albedo import decode_light
from omote.model.appearance.lab import to_lab
from omote.model.space.parameter_space import ParameterSpace

EVEN = 1.02
"""The longest step over the shortest, at which steps are even."""
ROUNDS = 8
GREY = 0.5
"""Linear light behind what is transparent."""
SHARE_PLACES = 6
"""Decimals of a share, as a mix is typed."""


class EvenSteps(NamedTuple):
    """Steps of a morph: shares (n,) of the last face, from 0 to 1; apart (n - 1,): how far each is from the next."""

    shares: tuple[float, ...]
    apart: Values


def measure_distance(space: ParameterSpace, one: Values, other: Values, /) -> float:
    """The root mean square of how far the vertices of the skin are apart, millimetres.

    space: of both, whose inner skin does not count; one, other (V, 3): metres.
    """
    away = (one - other)[space.on_sheet]
    return 1000.0 * float(np.sqrt((away**2).sum(axis=1).mean()))


def measure_difference(one: Picture, other: Picture, /) -> float:
    """The mean colour difference of two pictures, CIE 1976 (the distance of their pixels in L*a*b*, white of D65).

    Pixels that are transparent in both do not count; what is transparent lies on grey.

    one, other: (rows, columns, 3 or 4), sRGB.
    """
    if one.shape != other.shape:
        raise ValueError(f"pictures of {one.shape} and {other.shape} cannot be compared; expected one size and depth")
    counted = (one[..., 3:] > 0).any(axis=2) | (other[..., 3:] > 0).any(axis=2) if one.shape[2] == 4 else ...
    seen = [_light_of(picture[counted].reshape(-1, picture.shape[2])) for picture in (one, other)]
    away = np.linalg.norm(to_lab(seen[0]) - to_lab(seen[1]), axis=1)
    return float(away.mean()) if len(away) else 0.0


def _light_of(pixels: Picture) -> Values:
    """The linear light (n, 3) of pixels (n, 3 or 4)."""
    light = decode_light(pixels[:, :3]).astype(np.float64)
    cover = pixels[:, 3:] / 255.0 if pixels.shape[1] == 4 else np.ones((len(pixels), 1))
    return np.asarray(light * cover + GREY * (1.0 - cover))


def find_even_steps(
    count: int, measure: Callable[[Sequence[float]], Sequence[float]], /, apart: float | None = None, most: int = 1000
) -> EvenSteps:
    """Steps between two faces that are all about as far from the next; the most even of ROUNDS tries.

    Each try cuts the lengths of the steps before into equal parts; where in a step a cut lies is told by all that was
    measured so far. ValueError where nothing lies between the ends, and where it would take more steps than `most`.

    count: of the steps, the ends among them; measure: of shares that rise from 0 to 1 it gives how far each is from the
    next; apart: how far they are to be apart, as near as whole steps come: their count follows, from `count` on.
    """
    shares = tuple(np.linspace(0.0, 1.0, count).round(SHARE_PLACES).tolist())
    best = EvenSteps(shares, np.zeros(0))
    known: set[float] = set()
    for _ in range(ROUNDS):
        found = np.asarray(measure(shares), np.float64)
        known.update(shares)
        knots, length = _lengths(shares, found, sorted(known), measure)
        if not length[-1] > 0.0:
            raise ValueError("the two faces look alike, so there are no steps between them; give two that differ")
        wanted = len(shares) if apart is None else max(round(length[-1] / apart), 1) + 1
        if wanted > most:
            raise ValueError(f"steps of {apart:g} are {wanted}; give a distance of which there are {most} at most")
        if wanted == len(shares) and (len(best.apart) != len(found) or _unevenness(found) < _unevenness(best.apart)):
            best = EvenSteps(shares, found)
        if wanted == len(shares) and _unevenness(found) <= EVEN:
            break
        places = np.interp(np.linspace(0.0, length[-1], wanted), length, knots).round(SHARE_PLACES)
        shares = (0.0, *places[1:-1].tolist(), 1.0)
        if any(before >= after for before, after in pairwise(shares)):
            break
    return best


def _lengths(
    shares: Sequence[float],
    found: Values,
    knots: Sequence[float],
    measure: Callable[[Sequence[float]], Sequence[float]],
) -> tuple[Sequence[float], Values]:
    """How long the way is to each of the knots (k,), as long as steps were found at their shares, which are knots."""
    fine = np.asarray(measure(knots), np.float64)
    steps = np.searchsorted(shares, knots[:-1], side="right") - 1
    summed = np.bincount(steps, fine, len(found))
    scaled = fine * np.divide(found, summed, out=np.zeros_like(found), where=summed > 0.0)[steps]
    return knots, np.concatenate([[0.0], np.cumsum(scaled)])


def _unevenness(apart: Values) -> float:
    """The longest step over the shortest."""
    return float(apart.max() / apart.min()) if apart.min() > 0.0 else float("inf")
