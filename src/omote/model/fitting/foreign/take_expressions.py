"""Blendshapes of a stranger's head as expressions that every face wears: carried to the face that was fitted to it,
then extracted (paper, sections 2.2 and 5.1)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from omote.geometry import mesh
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import ExtractedExpression
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.foreign.carried_parts import carry_parts, find_parts
from omote.model.fitting.foreign.carried_skin import carry_skin
from omote.model.fitting.foreign.scan_correspondence import correspond
from omote.model.fitting.foreign.shape_doubts import explain_unfit
from omote.model.fitting.foreign.unfolded_field import turn_field_upright
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_skin import keep_skin
from omote.model.fitting.scan_surface import face_outward, sample_mesh
from omote.model.fitting.shape.head_zones import head_zones
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space

Values = NDArray[np.float64]
Follow = Callable[[float, str], None]
"""Told how much is done, 0 to 1, and which shape is next."""

# The scan is looked at so far around the face, metres.
AROUND = 0.03


@dataclass(frozen=True, eq=False)
class TakenExpressions:
    """Expressions from the shapes of a stranger's head.

    Attributes
    ----------
    expressions : mapping of ExtractedExpression, by name
        As the shapes are called; any face of the space wears them.
    notes : tuple of str
        Which shapes were left out, and why, in sentences.
    """

    expressions: Mapping[str, ExtractedExpression]
    notes: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class CarriedShape:
    """What a shape of a scan does to the face that was fitted to it: skin (V, 3), parts (n, 3) by name, metres."""

    skin: Values
    parts: Mapping[str, Values]


def take_expressions(
    space: ParameterSpace, fitted: Fit, scan: Scan, /, *, follow: Follow | None = None
) -> TakenExpressions:  # fmt: skip
    """Takes the named blendshapes of a scan of any topology as expressions that every face wears.

    Parameters
    ----------
    space : ParameterSpace
        The space of the fitted face.
    fitted : Fit
        The face that `omote.fit` made of the scan at rest.
    scan : Scan
        With triangles, and displacements of its points by the names of shapes, in its own frame and unit.
    follow : callable
        Told the progress.

    Returns
    -------
    TakenExpressions
        An expression for each shape that moves the face, and sentences about the others.

    Raises
    ------
    ValueError
        On a cloud without triangles, a scan without shapes, and one whose skin is not where the face is.

    Examples
    --------
    >>> kaori, space = cast.faces["kaori"], cast.space
    >>> smile = omote.compound(space, kaori, cast.expressions["smile"]) - kaori.positions
    >>> scan = omote.Scan(kaori.positions, space.triangles, shapes={"grin": smile})
    >>> fit = omote.fit(space, scan.positions, scan.triangles, landmarks=clicks)  # doctest: +SKIP
    >>> [*omote.take_expressions(space, fit, scan).expressions]  # doctest: +SKIP
    ['grin']

    References
    ----------
    K. Arai (1993), sections 2.2 and 5.1; docs/method.md, "Shapes of strangers".
    """
    refuse_no_space(space)
    carried = carry_shapes(space, fitted, scan)
    taken, notes = dict[str, ExtractedExpression](), list[str]()
    for done, (name, shape) in enumerate(carried.items()):
        if follow:
            follow(done / len(carried), name)
        trouble = explain_unfit(space, fitted.seen, shape.skin, shape.parts)
        if trouble:
            notes.append(f"{name!r} {trouble}, so it is left out.")
            continue
        try:
            taken[name] = turn_field_upright(space, extract(space, fitted.face, shape.skin, parts=shape.parts))
        except ValueError as error:
            notes.append(f"{name!r} is left out: {error}.")
    if follow:
        follow(1.0, "done")
    return TakenExpressions(MappingProxyType(taken), tuple(notes))


def carry_shapes(space: ParameterSpace, fitted: Fit, scan: Scan, /) -> dict[str, CarriedShape]:
    """What each shape of a scan does to the face that was fitted to it; errors as `take_expressions`."""
    if scan.triangles is None or not len(scan.triangles):
        raise ValueError("the scan is a cloud of points; expected triangles, along which its shapes can be carried")
    if not scan.shapes:
        raise ValueError("the scan has no shapes; export its head with its blendshapes (morph targets)")
    face, triangles = fit(space, fitted.face), np.asarray(scan.triangles)
    skin, points = face.positions.astype(np.float64), fitted.placement(scan.positions)
    box = np.stack([skin.min(axis=0), skin.max(axis=0)])
    sampled = sample_mesh(points, triangles, box, AROUND)
    outward = face_outward(sampled, (skin, mesh.normals(skin, space.triangles)))
    if outward is not sampled:
        triangles = triangles[:, ::-1]
    surface = keep_skin(outward, head_zones(space), skin)
    found = correspond(space, skin, points, triangles, surface)
    rows = np.unique(triangles[np.unique(surface.triangle)])
    parts = find_parts(space, face, points, triangles, rows)
    turn = fitted.placement.scale * fitted.placement.rotation
    moves = [each @ turn.T for each in scan.shapes.values()]
    skins = carry_skin(space, skin, found, moves)
    return {
        name: CarriedShape(moved, carry_parts(parts, face, points, move))
        for name, moved, move in zip(scan.shapes, skins, moves, strict=True)
    }
