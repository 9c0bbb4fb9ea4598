"""What limb fields a figure wears in a frame: those that are called, and those that bends and breath drive."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from omote.arrays import Values
from omote.model.body.correctives import HINGES
from omote.model.body.figures import Figures
from omote.model.body.limb_field import LimbField
from omote.model.body.limb_recipe import BREATH
from omote.model.body.limbs import limb_axes, limb_moves
from omote.perform.figures.figure import RestingFigure
from omote.perform.mix import Weights

TENSED = (30.0, 130.0)
"""Degrees of a hinge from which on it drives a field, and at which it drives all of it."""
_HINGES = {hinge[1]: place for place, hinge in enumerate(HINGES)}


def limb_weights(
    fields: Mapping[str, LimbField], called: Weights, bends: Values, breath: float
) -> dict[str, float]:  # fmt: skip
    """How much of each limb field a figure wears, of those that weigh something.

    What is called and what drives a field do not add up: the larger shows, as of gaze and channels.

    fields: by name; called: weights of expressions and channels, by name; bends (4,): of the hinges, degrees; breath:
    how much of one is in the chest.
    """
    worn = {}
    for name, field in fields.items():
        wanted = called.get(name, 0.0)
        driven = _driven(field.driver, bends, breath)
        weight = driven if abs(driven) > abs(wanted) else wanted
        if weight:
            worn[name] = weight
    return worn


def _driven(driver: str, bends: Values, breath: float) -> float:
    if driver == BREATH:
        return breath
    if driver not in _HINGES:
        return 0.0
    slack, tense = TENSED
    return min(max((float(bends[_HINGES[driver]]) - slack) / (tense - slack), 0.0), 1.0)


def wear_limb_fields(figures: Figures, resting: RestingFigure, weights: Weights) -> RestingFigure:
    """A figure before it is posed with its limbs as fields move them.

    figures: of the cast; resting: of `resting_figure`; weights: of `limb_weights`.
    """
    if not weights:
        return resting
    values = np.sum([weight * figures.limb_fields[name].values for name, weight in weights.items()], axis=0)
    rows = resting.rows.copy()
    axes = limb_axes(figures.space.skeleton, resting.joints)
    rows[figures.limbs.rows] += limb_moves(figures.limbs, axes, resting.rows, values)
    return replace(resting, rows=rows)
