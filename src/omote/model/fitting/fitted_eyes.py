"""Where the eyeballs of a fitted face are: where the scan shows balls of its own, else where its lids say."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Values
from omote.model.fitting.scan_surface import ScanSurface
from omote.model.space.eye_socket import FAR, NEAR, ball_heights, fall_off, radius_of, set_ball_heights
from omote.model.space.parameter_space import ParameterSpace

Ball = tuple[Values, float]
"""The middle (3,) and the radius of an eyeball, metres."""

# A ball of the scan: its middle lies so near to where one is expected, in radii, and is so much as large.
BESIDE = 0.6
SIZES = (0.6, 1.4)
# It is round within this share of its radius in the mean, and reaches so far around it in each axis, in radii.
ROUND = 0.05
AROUND = 1.2
FEWEST = 60
ENOUGH = 400
# How sure the place (metres) and the logarithm of the size are that modes and skin around give, beside one lid vertex.
PLACE = 0.002
SIZE = 0.05
HEIGHT = 0.25
# Lids lie at least so high over the ball, in radii, but for those that lie deeper on the generic head.
CLEAR = 1.01


def find_balls(surface: ScanSurface, expected: Mapping[str, Values], /) -> dict[str, Ball]:
    """The balls that a scan shows near expected eyeballs (n, 3), by name; surface: all of it, not only its skin."""
    balls = {name: _find_ball(surface, ball) for name, ball in expected.items()}
    return {name: ball for name, ball in balls.items() if ball is not None}


def place_balls(
    space: ParameterSpace, expected: Mapping[str, Values], skin: Values, seen: Mapping[str, Ball], /
) -> dict[str, Values]:
    """The eyeballs (n, 3) by name, where they were seen, else near where they are expected, as the lids of a
    fitted skin (V, 3) say.

    space: of the face; expected: eyeballs where modes and skin put them, metres; skin (V, 3): metres; seen: balls that
    the scan shows.
    """
    placed = {}
    for name, ball in expected.items():
        middle, radius = seen[name] if name in seen else _fit_to_lids(space, name, ball, skin)
        placed[name] = middle + (ball - ball.mean(axis=0)) * (radius / radius_of(ball))
    return placed


def _find_ball(surface: ScanSurface, expected: Values) -> Ball | None:
    """The middle and the radius of the widest component that is a ball near the expected one."""
    middle = expected.mean(axis=0)
    radius = radius_of(expected)
    near = surface.tree.query_ball_point(middle, radius * (1.0 + BESIDE) * SIZES[1])
    labels, counts = np.unique(surface.component[near], return_counts=True)
    balls = list[tuple[float, Values]]()
    for label in labels[counts >= FEWEST]:
        points = surface.points[surface.component == label]
        points = points[:: max(len(points) // ENOUGH, 1)]
        seen, size = fit_sphere(points)
        off = points - seen
        around = np.ptp(off, axis=0).min() > AROUND * size
        even = np.median(np.abs(np.linalg.norm(off, axis=1) - size)) < ROUND * size
        beside = np.linalg.norm(seen - middle) < BESIDE * radius
        if around and even and beside and SIZES[0] < size / radius < SIZES[1]:
            balls.append((size, seen))
    size, seen = max(balls, key=lambda ball: ball[0], default=(0.0, middle))
    return (seen, size) if balls else None


def fit_sphere(points: Values, /) -> tuple[Values, float]:
    """The middle (3,) and the radius of the sphere nearest to points (n, 3), those off it counted less (Tukey)."""
    centre = points.mean(axis=0)
    local = points - centre
    weights = np.ones(len(points))
    middle = np.zeros(3)
    radius = 1.0
    for _ in range(12):
        system = np.column_stack([2.0 * local, np.ones(len(local))]) * weights[:, None]
        answer = np.linalg.lstsq(system, (local**2).sum(axis=1) * weights, rcond=None)[0]
        middle = answer[:3]
        radius = float(np.sqrt(max(answer[3] + answer[:3] @ answer[:3], 1e-12)))
        off = np.linalg.norm(local - middle, axis=1) - radius
        wide = max(4.0 * float(np.median(np.abs(off))), 1e-5)
        weights = np.maximum(1.0 - (off / wide) ** 2, 0.0)
    return centre + middle, radius


def _fit_to_lids(space: ParameterSpace, name: str, ball: Values, skin: Values) -> tuple[Values, float]:
    """The ball over which the lids lie as high as on the generic head, not far from where it is expected."""
    wanted = ball_heights(space.points, space.parts[name].points)
    rows = np.flatnonzero(space.on_sheet & (wanted < NEAR))
    start = ball.mean(axis=0)
    first = radius_of(ball)
    state = np.zeros(4)
    for _ in range(8):
        size = first * np.exp(state[3])
        off = skin[rows] - (start + state[:3])
        length = np.linalg.norm(off, axis=1)
        left = length / size - wanted[rows]
        slopes = np.column_stack([-off / (length * size)[:, None], -length / size])
        share = HEIGHT**-2 * np.maximum(1.0 - (left / 0.3) ** 2, 0.0)
        prior = np.array([PLACE**-2] * 3 + [SIZE**-2])
        matrix = slopes.T @ (slopes * share[:, None]) + np.diag(prior)
        state -= np.linalg.solve(matrix, slopes.T @ (share * left) + prior * state)
    return start + state[:3], float(first * np.exp(state[3]))


def seat_lids(space: ParameterSpace, skin: Values, balls: dict[str, Values], /) -> Values:
    """The skin (V, 3) with the lining of the sockets as high over the balls as on the generic head, and the lids not in
    them.

    space: of the face; skin (V, 3): metres; balls: points of the eyeballs by name, metres.
    """
    wanted = {}
    for name, ball in balls.items():
        rest = ball_heights(space.points, space.parts[name].points)
        now = ball_heights(skin, ball)
        lids = np.where(now < np.minimum(rest, CLEAR), np.minimum(rest, CLEAR), now)
        lids = np.where(rest > FAR, rest, np.minimum(lids, FAR))
        share = fall_off((rest - NEAR) / (FAR - NEAR))
        wanted[name] = np.where(space.on_sheet | (share == 0.0), np.where(rest > FAR, rest, lids), rest)
    return set_ball_heights(skin, balls, wanted)
