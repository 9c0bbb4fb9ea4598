"""Eye sockets: keeps the distance of lids and skin to the eyeball when a face changes."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.geometry.ramp import smooth_ramp

# In radii of the ball: skin below NEAR gets exactly the height that is asked for, skin above FAR stays where it is.
NEAR = 1.12
FAR = 1.6


def ball_heights(skin: NDArray[np.floating], ball: NDArray[np.floating], /) -> Values:
    """The distance of each vertex of the skin (V, 3) from the middle of an eyeball (n, 3), in the ball's radii:
    (V,)."""
    return np.linalg.norm(skin.astype(np.float64) - ball.mean(axis=0), axis=1) / radius_of(ball)


def set_ball_heights(skin: Values, balls: Mapping[str, Values], wanted: Mapping[str, Values], /) -> Values:
    """Moves the vertices of the skin (V, 3) around each eyeball (n, 3) to the wanted heights (V,) over it, in radii;
    the wanted heights also say which vertices lie around it.

    balls: (n, 3) each, metres, by name; others than those that are wanted say nothing.
    """
    result = skin.copy()
    for name, rest in wanted.items():
        ball = balls[name]
        now = ball_heights(result, ball)
        hold = fall_off((rest - NEAR) / (FAR - NEAR))
        share = hold * (rest - now) / np.maximum(now, 1e-9)
        result += (result - ball.mean(axis=0)) * share[:, None]
    return result


def move_ball(ball: Values, before: Values, after: Values, /) -> Values:
    """Moves and scales an eyeball (n, 3) as another went from before to after (n, 3); it stays round and its gaze
    stays, whatever happened to the other's form.

    ball: (n, 3), metres.
    """
    shift = before.mean(axis=0) - ball.mean(axis=0)
    return move_with_ball(ball + shift, before, after) - shift


def move_with_ball(points: Values, before: NDArray[np.floating], after: NDArray[np.floating], /) -> Values:
    """Moves and scales points (m, 3) as an eyeball went from before to after (n, 3)."""
    larger = radius_of(after) / radius_of(before)
    return (points - before.mean(axis=0)) * larger + after.mean(axis=0)


def radius_of(ball: NDArray[np.floating], /) -> float:
    """The root mean square distance of an eyeball's vertices (n, 3) to their centre, metres."""
    return float(np.sqrt(((ball - ball.mean(axis=0)) ** 2).sum(axis=1).mean()))


def fall_off(share: Values) -> Values:
    """1 up to zero, 0 from one on, with a soft step between."""
    return 1.0 - smooth_ramp(0.0, 1.0, share)
