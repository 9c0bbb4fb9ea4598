"""Binds the parts of the baked head (eyes, teeth, lashes, tongue) to its skin; the bake and the loader share the
rule."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.arrays import Indices, Values
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.parts import Part, bind_to_head, bind_to_jaw, bind_to_skin
from omote.model.transfer.gum_line import bind_to_gums

AXIS = (0.0, 0.02)  # x and z of the cylinder axis, metres (docs/method.md, "The cylinder")
EYES = {"eye_left": "left", "eye_right": "right"}
STILL = (*EYES, "teeth_upper")
JAW = ("teeth_lower", "tongue")
LASHES = "lashes"
TEETH = ("teeth_upper", "teeth_lower")
LIDS = {"lid_left": "eye_left", "lid_right": "eye_right"}
LIPS = "lips"
PARTS = (*STILL, *JAW, LASHES)


@dataclass(frozen=True, eq=False)
class PartMesh:
    """A part as baked: points (n, 3) metres on the generic face, triangles (t, 3)."""

    points: Values
    triangles: Indices


def head_space(
    points: Values, triangles: Indices, parts: Mapping[str, PartMesh], jaw: Indices, sheet: Indices | None = None
) -> ParameterSpace:
    """The parameter space of the baked head with its parts bound, its lids and lips named, its gums bound to
    the jaws.

    points (V, 3) metres, triangles (F, 3) of the generic skin; parts by the names in PARTS; jaw (m,): the skin vertices
    that show where the jaw is; sheet (f, 3): the triangles of the skin sheet, found where they are not known.
    """
    space = ParameterSpace.build(points, triangles, axis=AXIS, sheet=sheet)
    skin = np.flatnonzero(space.on_sheet).astype(np.int32)
    jaw = np.intersect1d(jaw, skin).astype(np.int32)
    bound = space.with_parts(*(_bind(name, parts[name], space.points, skin, jaw) for name in PARTS))
    for line, eye in LIDS.items():
        bound = bound.with_line(line, "lids", parts[eye].points.mean(axis=0))
    bound = bound.with_line(LIPS, "lips", np.concatenate([parts[name].points for name in TEETH]).mean(axis=0))
    return bind_to_gums(bound)


def _bind(name: str, part: PartMesh, skin: Values, sheet: Indices, jaw: Indices) -> Part:
    if name in JAW:
        return bind_to_jaw(name, part.points, part.triangles, skin, candidates=sheet, chin=jaw)
    if name == LASHES:
        return bind_to_skin(name, part.points, part.triangles, skin, candidates=sheet)
    return bind_to_head(name, part.points, part.triangles, skin, candidates=sheet, eye=EYES.get(name, ""))
