"""Validates a face against a space and precomputes what every compound on it needs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np

from omote.arrays import Floats, Values
from omote.model.space.face import Face
from omote.model.space.lid_lip_lines import jaw_amplitude
from omote.model.space.parameter_space import ParameterSpace, smoothed_scale
from omote.model.space.parts import place, size_ratio
from omote.model.space.skin_sheet import refuse_axis_outside, refuse_degenerate
from omote.model.weak_cache import weakly_cached, weakly_cached_with

# Inner skin moves as far as on the generic face where this one is larger or smaller by less than this (logarithm of the
# sizes): people's amplitudes do not grow with their heads. Only what sizes differ by beyond that scales it.
ALIKE = 0.15


@dataclass(frozen=True, eq=False)
class FittedFace:
    """A face checked against a space, with what every compound on it needs.

    positions (V, 3), radii (V,) to the axis, scale (inner,) of the residuals; parts (n, 3) placed, their centres, and
    sizes, the scale of their residuals.
    """

    positions: Floats
    radii: Floats
    scale: Floats
    parts: Mapping[str, Floats]
    sizes: Mapping[str, float]
    centres: Mapping[str, Values]

    def ball_radius(self, eye: str) -> float:
        """The radius of an eyeball by its part's name, metres: the mean distance of its vertices to their centre."""
        return float(np.linalg.norm(self.parts[eye] - self.centres[eye], axis=1).mean())


@weakly_cached
def generic_face(space: ParameterSpace, /) -> Face:
    """The face M0 of a space, on which expressions are defined."""
    parts = {name: part.points.astype(np.float32) for name, part in space.parts.items()}
    return Face("generic", space.points, parts)


def fit(space: ParameterSpace, face: Face, /) -> FittedFace:
    """Validates a face and prepares it for compounds; cached as long as the face lives.

    space: the space of the generic head.

    Raises ValueError where the face has another topology, triangles without area, or does not stand around the axis;
    TypeError where it is none.
    """
    if not isinstance(face, Face):
        raise TypeError(f"the face is a {type(face).__name__}; expected an omote.Face, such as cast.faces['generic']")
    return _fit(space, face)


@weakly_cached_with
def _fit(space: ParameterSpace, face: Face) -> FittedFace:
    _refuse_misfit(space, face)
    points = face.positions.astype(np.float64)
    parts = {
        name: np.asarray(face.parts.get(name, place(part, space.points, points)), np.float32)
        for name, part in space.parts.items()
    }
    sizes = _scale_parts(space, points, parts)
    _, _, radii = space.cylinder.unroll(points)
    return FittedFace(
        positions=np.asarray(face.positions, np.float32),
        radii=radii.astype(np.float32),
        scale=_scale_residuals(space, points, sizes).astype(np.float32),
        parts=MappingProxyType(parts),
        sizes=MappingProxyType(sizes),
        centres=MappingProxyType({name: points.astype(np.float64).mean(axis=0) for name, points in parts.items()}),
    )


def _scale_parts(space: ParameterSpace, points: Values, parts: Mapping[str, Floats]) -> dict[str, float]:
    """The scale of each part's residual: its size; of what follows the jaw, the jaw's amplitude under the smooth map.

    The residual of teeth and tongue is the jaw's turn beyond the chin's mean: scaled otherwise than the chin, teeth go
    through lips of heads whose teeth are large.
    """
    sizes = {name: size_ratio(part, parts[name].astype(np.float64)) for name, part in space.parts.items()}
    amplitude = jaw_amplitude(space.lines, space.points, points) if space.transfer == "smooth" else None
    if amplitude is not None:
        sizes |= {name: amplitude for name, part in space.parts.items() if part.follows_jaw}
    return sizes


def _scale_residuals(space: ParameterSpace, points: Values, sizes: Mapping[str, float]) -> Values:
    """How much larger what the inner skin does by itself is on the face at each of its vertices, (inner,): its local
    size beyond what people differ by; where it goes with the jaw, the scale of what else does: they move together."""
    inner = space.inner
    scale = smoothed_scale(space, points)[inner.vertices]
    if space.transfer == "smooth":  # the paper's map scales the sheet too
        far = np.log(scale)
        scale = np.exp(np.sign(far) * np.maximum(np.abs(far) - ALIKE, 0.0))
    jaw = next((part for part in space.parts.values() if part.follows_jaw), None)
    if jaw is None:
        return scale
    share = np.where(np.isin(inner.anchors, jaw.anchors[0]), inner.weights, 0.0).sum(axis=1)
    return np.asarray(scale + share * (sizes[jaw.name] - scale))


def _refuse_misfit(space: ParameterSpace, face: Face) -> None:
    if len(face.positions) != space.vertex_count:
        raise ValueError(
            f"face {face.name!r} has {len(face.positions)} vertices; "
            f"expected the {space.vertex_count} of the generic face: bring it to the same topology first"
        )
    for name, points in face.parts.items():
        if name not in space.parts or len(points) != len(space.parts[name].points):
            known = {part: len(space.parts[part].points) for part in space.parts}
            raise ValueError(
                f"face {face.name!r} has a part {name!r} of {len(points)} vertices; expected parts of {known}"
            )
    positions = face.positions.astype(np.float64)
    refuse_degenerate(positions, space.triangles)
    refuse_axis_outside(positions, space.location_triangles, space.cylinder)
