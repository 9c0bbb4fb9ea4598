"""What the smooth map needs of a face, solved once per face (docs/method.md, "The smooth map").

The stages that apply it to an expression, in order, are `omote.model.transfer.pipeline.STAGES`; its inverse is in
`omote.model.extraction.extract`.
"""

from __future__ import annotations

from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.space.face import Face
from omote.model.space.face_fit import FittedFace, fit, generic_face
from omote.model.space.lid_lip_lines import Line, jaw_amplitude
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.detail_transfer import DetailSolver, factor_detail
from omote.model.transfer.eyes.eyeball_clearance import Clearance, Eyeball, build_clearance
from omote.model.transfer.fold_repair import SheetGeometry, build_sheet_geometry
from omote.model.transfer.lid_lip_contact import Contact, build_contact, compute_gain

Values = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class SmoothMap:
    """The map from the generic face to another, solved once.

    generic, positions (V, 3): both faces at rest, metres; geometry: the triangles of the sheet on both; detail: the
    factorised system of `transfer_detail`; contacts: one per line of lids or lips; on_line (V,): the vertices on these
    lines; clearances: one per eyeball; gain (V,): how much larger a displacement becomes at each vertex.
    """

    generic: Values
    positions: Values
    geometry: SheetGeometry
    detail: DetailSolver
    contacts: tuple[Contact, ...]
    on_line: Mask
    clearances: tuple[Clearance, ...]
    gain: Values


_prepared: WeakKeyDictionary[Face, tuple[ParameterSpace, SmoothMap]] = WeakKeyDictionary()


def prepare_smooth_map(space: ParameterSpace, face: Face, /) -> SmoothMap:
    """The smooth map to a face, solved at the first call and remembered as long as the face lives."""
    fitted, known = fit(space, face), _prepared.get(face)  # fit first: it rejects what is no face of the space
    if known is None or known[0] is not space:
        generic = fit(space, generic_face(space))
        here, there = fitted.positions.astype(np.float64), generic.positions.astype(np.float64)
        eyeballs = tuple(zip(_eyeballs(space, generic), _eyeballs(space, fitted), strict=True))
        known = (space, build_smooth_map(there, here, space.sheet_triangles, space.lines, eyeballs))
        _prepared[face] = known
    return known[1]


def build_smooth_map(
    generic: Values, positions: Values, triangles: NDArray[np.int32], lines: tuple[Line, ...],
    eyeballs: tuple[tuple[Eyeball, Eyeball], ...] = (), /,
) -> SmoothMap:  # fmt: skip
    """The map for displacements of the generic face (V, 3) to the face with positions (V, 3).

    triangles (T, 3): the sheet's; lines: of lids and lips; eyeballs: each of the generic face with the same one of this
    face.
    """
    geometry = build_sheet_geometry(generic, positions, triangles)
    on_line = np.zeros(len(generic), np.bool_)
    for line in lines:
        on_line[line.loop] = True
    contacts = tuple(build_contact(line, generic, positions, geometry) for line in lines)
    clearances = tuple(build_clearance(generic, positions, triangles, there, here) for there, here in eyeballs)
    amplitude = jaw_amplitude(lines, generic, positions)
    gain = compute_gain(generic, contacts, 1.0 if amplitude is None else amplitude)
    return SmoothMap(
        generic, positions, geometry, factor_detail(geometry), contacts, on_line, clearances, gain
    )  # fmt: skip


def _eyeballs(space: ParameterSpace, fitted: FittedFace) -> tuple[Eyeball, ...]:
    """The eyeballs of a face, in the order of the space's parts."""
    eyes = [name for name, part in space.parts.items() if part.eye]
    return tuple(Eyeball(fitted.centres[name], fitted.ball_radius(name)) for name in eyes)
