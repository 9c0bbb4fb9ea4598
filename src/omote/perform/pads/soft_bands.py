"""Soft bands (Numba): how much each of a few places weighs at a point; of + - * / and sqrt alone, each rounded as IEEE
754 says, so that a show replays bit for bit on any machine."""

from __future__ import annotations

from math import sqrt

from numba import float64, njit, types, void

from omote.arrays import Values

_READ = types.Array(float64, 2, "C", readonly=True)
_WRITE = types.Array(float64, 1, "C")


@njit(void(_READ, *[float64] * 3, _WRITE), cache=True, error_model="numpy")
def soft_bands(places: Values, x: float, y: float, z: float, out: Values) -> None:
    """Writes the weights (n,) of places (n, 3) at the point x, y, z into out (n,): each 0 to 1, together 1.

    A place weighs 1 / (1 + sum of g(t)) over the others, where t goes from 0 at it to 1 at the other one and g(t) is
    nothing up to 0, (t / (1 - t)) to the power 1.5, and without end from 1 on; then all are divided by their sum.
    """
    count = places.shape[0]
    total = 0.0
    for i in range(count):
        ax, ay, az = x - places[i, 0], y - places[i, 1], z - places[i, 2]
        against = 1.0
        for j in range(count):
            if j == i:
                continue
            bx, by, bz = places[j, 0] - places[i, 0], places[j, 1] - places[i, 1], places[j, 2] - places[i, 2]
            along = (ax * bx + ay * by + az * bz) / (bx * bx + by * by + bz * bz)
            if along >= 1.0:
                against = 0.0
                break
            if along > 0.0:
                ratio = along / (1.0 - along)
                against += ratio * sqrt(ratio)
        out[i] = 1.0 / against if against else 0.0
        total += out[i]
    for i in range(count):
        out[i] /= total
