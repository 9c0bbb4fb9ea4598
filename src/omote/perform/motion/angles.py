"""Angles without the platform's sine or arc tangent, so that a replay gives the same bits on every machine."""

from __future__ import annotations

import math

HALF_TURN, FULL_TURN = math.pi, 2.0 * math.pi
_ARC_TERMS = tuple((-1.0) ** term / (2 * term + 1) for term in range(7))
_SINE_TERMS = (1.0, -1 / 6, 1 / 120, -1 / 5040, 1 / 362880, -1 / 39916800)
_COSINE_TERMS = (1.0, -1 / 2, 1 / 24, -1 / 720, 1 / 40320, -1 / 3628800, 1 / 479001600)


def angle_of(across: float, ahead: float) -> float:
    """The angle of a direction from straight ahead, as `math.atan2`: radians, -pi to pi; 0 for none."""
    if abs(across) <= abs(ahead):
        turned = 0.0 if ahead == 0.0 else _arc_tangent(across / ahead)
        return turned if ahead >= 0.0 else turned + (HALF_TURN if across >= 0.0 else -HALF_TURN)
    quarter = HALF_TURN / 2.0 if across > 0.0 else -HALF_TURN / 2.0
    return quarter - _arc_tangent(ahead / across)


def sine_cosine(angle: float) -> tuple[float, float]:
    """Sine and cosine of an angle in radians."""
    part = wrap_angle(angle) / 4.0  # at most 45 degrees, where the series need few terms
    square = part * part
    sine, cosine = part * _polynomial(_SINE_TERMS, square), _polynomial(_COSINE_TERMS, square)
    for _ in range(2):
        sine, cosine = 2.0 * sine * cosine, cosine * cosine - sine * sine
    return sine, cosine


def wrap_angle(angle: float) -> float:
    """The same direction as an angle from -pi to pi."""
    return angle - FULL_TURN * math.floor(angle / FULL_TURN + 0.5)


def _arc_tangent(slope: float) -> float:
    """The arc tangent of -1 to 1: the angle is halved twice, where its series needs few terms."""
    for _ in range(2):
        slope /= 1.0 + math.sqrt(1.0 + slope * slope)
    return 4.0 * slope * _polynomial(_ARC_TERMS, slope * slope)


def _polynomial(terms: tuple[float, ...], square: float) -> float:
    total = 0.0
    for term in reversed(terms):
        total = total * square + term
    return total
