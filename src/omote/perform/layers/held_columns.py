"""What hands hold over the layers: which columns, how much, and that what is let go keeps its value while it goes."""

from __future__ import annotations

import numpy as np

from omote.perform.channels import effective_channels
from omote.perform.frame import Gaze, Head, Held, with_fields
from omote.perform.layers.columns import GAZE, HEAD, Columns, HasExpressions
from omote.perform.layers.follower import Values
from omote.perform.layers.layer_vectors import Layers, with_names

UPRIGHT, STRAIGHT = Head(), Gaze()


def hold_by(cast: HasExpressions, layers: Layers, held: Held) -> Layers:
    """The layers under what hands hold now; what a hand lets go keeps its value while the hold goes."""
    layers = with_names(cast, layers, held.channels)
    columns, goal = layers.columns, layers.goal.copy()
    hands, hold = columns.sections["hands"], columns.sections["hold"]
    holds, wanted = _hold_of(cast, columns, held)
    goal[hold] = holds
    np.copyto(goal[hands], wanted, where=holds > 0.0)
    first, second = layers.first.copy(), layers.second.copy()
    free = layers.calm | ((first[hold] == 0.0) & (second[hold] == 0.0))
    for vector in (first, second):
        np.copyto(vector[hands], goal[hands], where=free)
        if layers.calm:
            vector[hold] = holds
    return with_fields(layers, goal=goal, first=first, second=second, held=held)


def _hold_of(cast: HasExpressions, columns: Columns, held: Held) -> tuple[Values, Values]:
    holds, wanted = np.zeros(columns.width), np.zeros(columns.width)
    channels = effective_channels(cast.expressions, held.channels, held.gaze)
    places = columns.places(tuple(channels))
    holds[places], wanted[places] = 1.0, list(channels.values())
    if held.head != UPRIGHT:
        holds[HEAD], wanted[HEAD] = 1.0, (held.head.yaw, held.head.pitch, held.head.roll)
    if held.gaze != STRAIGHT:
        holds[columns.places(columns.eyes)] = 1.0
        holds[GAZE], wanted[GAZE] = 1.0, (held.gaze.yaw, held.gaze.pitch)
    return holds, wanted


def are_hands_settled(layers: Layers) -> bool:
    """Whether all that hands hold, and all that they have let go, is where it goes."""
    begin, end = layers.columns.sections["hands"].start, layers.columns.sections["hold"].stop
    where = slice(begin, end)
    return np.array_equal(layers.first[where], layers.goal[where]) and np.array_equal(
        layers.second[where], layers.goal[where]
    )
