"""Faces of nobody: random weights of the identity modes, closed as the face of a scan is, and looked through."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from omote.arrays import Mask, Values
from omote.geometry import mesh
from omote.model.fitting.fit_face import close_face, set_upright
from omote.model.fitting.identity_modes import IdentityModes
from omote.model.fitting.skin_repair import find_folds
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity
from omote.model.transfer.compound import compound
from omote.model.transfer.teeth_clearance import are_teeth_inside

MOST_DEVIATIONS = 2.5
"""No weight is drawn farther from the mean head, in standard deviations of its mode."""
BLINKS = ("eyeBlinkLeft", "eyeBlinkRight")
TRIED = (*BLINKS, "jawOpen", "mouthFunnel", "joy", "angry")
"""What a new face wears before it is given out."""
LEFT_OPEN = 0.05
"""Of an eye that is shut, the share of its height that may stay open or overlap."""


def draw_identity(space: ParameterSpace, modes: IdentityModes, name: str, draw: np.random.Generator, /) -> Face:
    """The face of somebody who differs from the mean head as people do: independent normal weights of all modes.

    space: the built-in cast's; modes: what heads differ by; name: the face's; draw: of the weights. ValueError where
    what was drawn cannot be a head.
    """
    drawn = draw.standard_normal(len(modes.moves))
    weights = np.minimum(np.maximum(drawn, -MOST_DEVIATIONS), MOST_DEVIATIONS)
    skin = modes.shape_skin(weights)
    parts = modes.shape_parts(weights)
    upright = set_upright(space, Similarity(1.0, np.eye(3), np.zeros(3)), parts, skin, True)
    placed = {part: upright(points) for part, points in parts.items()}
    return close_face(space, name, upright(modes.skin), upright(skin), placed)


def find_faults(
    space: ParameterSpace, guide: Values, face: Face, worn: Mapping[str, Expression], /
) -> tuple[str, ...]:  # fmt: skip
    """What is wrong with a face, in words: folds at rest and in expressions, eyes that do not shut, teeth outside.

    space: of the face; guide: the skin (V, 3) of a head without folds; worn: what is tried, by name; of TRIED those
    that shut eyes are asked for that.
    """
    rest = face.positions.astype(np.float64)
    faults = []
    if len(find_folds(space, guide, rest)):
        faults.append("its skin is folded at rest")
    if not are_teeth_inside(space, fit(space, face)):
        faults.append("its teeth are outside of its skin")
    generic = Face("generic", space.points)
    for name, expression in worn.items():
        now = compound(space, face, expression).astype(np.float64)
        at_source = _find_turned(space, space.points, compound(space, generic, expression).astype(np.float64))
        if (_find_turned(space, rest, now) & ~at_source).any():
            faults.append(f"{name} folds its skin")
        lids = _find_lids(space, name)
        if lids is not None and abs(_measure_opening(lids, rest, now)) > LEFT_OPEN:
            faults.append(f"{name} does not shut its eye")
    return tuple(faults)


def _find_turned(space: ParameterSpace, rest: Values, now: Values) -> Mask:
    """The sheet's triangles (t,) that face away from where they faced at rest."""
    before, after = (mesh.unit_normals(skin[space.sheet_triangles]) for skin in (rest, now))
    turned: Mask = (before * after).sum(axis=1) < 0.0
    return turned


def _find_lids(space: ParameterSpace, name: str) -> Line | None:
    """The lids that an expression shuts, None where it is none of BLINKS: left is x > 0."""
    if name not in BLINKS:
        return None
    side = 1.0 if name == BLINKS[0] else -1.0
    eyes = (line for line in space.lines if line.kind == "lids" and side * space.points[line.loop, 0].mean() > 0.0)
    return next(eyes, None)


def _measure_opening(lids: Line, rest: Values, now: Values) -> float:
    """How far lids are open on a skin (V, 3), as a share of rest: the projections of their rungs."""
    still = lids.rungs(rest)
    length = np.linalg.norm(still, axis=1)
    return float(((still * lids.rungs(now)).sum(axis=1) / length).sum() / length.sum())
