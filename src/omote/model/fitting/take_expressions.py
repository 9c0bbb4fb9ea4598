"""Blendshapes of a stranger's head as expressions that every face wears.

They are carried to the face that was fitted to it, as the scan where that is sure, as a thin plate where it is not,
then extracted (paper, sections 2.2 and 5.1). Lids meet where the scan's are seen to. What is folded on the
generic head is repaired: on a face only what is no fold there would be, and every face would wear folds that the
stranger has not. The bake does the same to the cast's own units (`tools/baking/heads/fold_repair`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from omote.arrays import Values
from omote.geometry import mesh
from omote.geometry.laplacian import bending_energy, factor_symmetric
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import ExtractedExpression
from omote.model.extraction.sheet_field import measure_field
from omote.model.fitting.carried_parts import carry_parts, find_parts
from omote.model.fitting.fit_face import Fit, Follow
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.lids.lid_motion import describe_lids, lid_pairs, shut_lids
from omote.model.fitting.lids.scan_slits import find_slit
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_correspondence import Correspondence, correspond
from omote.model.fitting.scan_skin import keep_skin
from omote.model.fitting.scan_surface import face_outward, sample_mesh, whole_sheets
from omote.model.space.face_fit import fit, generic_face
from omote.model.space.head_regions import region_weights
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.transfer.fold_repair import find_folds, repair_patch
from omote.model.transfer.lid_lip_contact import close_contact
from omote.model.transfer.paper_map import compile_expression, displace_generic
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map

# What moves less than the first, metres, holds nothing; what moves farther than the second is no face's.
NOTHING = 1e-4
HUGE = 0.1
# An expression leaves the skull at rest: it moves there no more than this share of how far it moves the face.
SKULL = 0.25
# A vertex is the skull's by so much, and was seen by so much.
OWNED = 0.6
SEEN_ENOUGH = 0.3
# The plate's stiffness as a length beside a match that is sure, and how far it holds by itself, metres.
PLATE_LENGTH = 0.0003
HOLD = 0.05
# What is sure no more than this is not asked.
LEAST = 1e-3
REPAIR_ROUNDS = 30
# Lips that go so far over each other, metres in the mean, close an open jaw: alone they are to lie over each other, and
# so is what they fold.
OVER = 0.012
# The scan is looked at so far around the face, metres.
AROUND = 0.03


def explain_unfit(space: ParameterSpace, seen: Values, skin: Values, parts: Mapping[str, Values], /) -> str:
    """Why a displacement of skin (V, 3) and parts is no expression, as the rest of a sentence about it; "" for one.

    seen (V,): how much of each vertex the scan shows.

    space: of the face; skin (V, 3), parts (n, 3) by name: displacements, metres.
    """
    face = np.linalg.norm(skin[head_zones(space).face], axis=1)
    most = max([float(face.max())] + [float(np.linalg.norm(moved, axis=1).max()) for moved in parts.values()])
    if most < NOTHING:
        return "moves nothing of the face"
    if most > HUGE:
        return f"moves the face by {100.0 * most:.0f} cm, more than any expression"
    skull = (region_weights(space)["skull"] > OWNED) & space.on_sheet & (seen > SEEN_ENOUGH)
    if skull.any():
        far = float(np.median(np.linalg.norm(skin[skull], axis=1)))
        if far > max(SKULL * float(np.quantile(face, 0.95)), NOTHING):
            return "moves the skull with the face: it is another head, or a turn of it, and no expression"
    return ""


def carry_skin(
    space: ParameterSpace, skin: Values, correspondence: Correspondence, shapes: list[Values], /
) -> list[Values]:
    """The displacements (V, 3) of a skin (V, 3) by shapes (n, 3) of a scan, in the skin's frame; inner skin follows.

    space, skin (V, 3): the face, metres; correspondence: where it lies on the scan; shapes: displacements (n, 3),
    metres.
    """
    used, numbered = np.unique(space.sheet_triangles, return_inverse=True)
    sheet = numbered.reshape(-1, 3).astype(np.int32)
    points = skin[used]
    energy, area = bending_energy(points, sheet)
    area = np.maximum(area, 1e-10)
    sure = np.where(correspondence.sure[used] > LEAST, correspondence.sure[used], 0.0)
    held = PLATE_LENGTH**4 * energy + sparse.diags_array(area * (sure + (PLATE_LENGTH / HOLD) ** 4))
    factor = factor_symmetric(held)
    result = []
    for moves in shapes:
        goal = correspondence.carry(moves)[used]
        result.append(_spread(space, used, factor.solve((area * sure)[:, None] * goal)))
    return result


def _spread(space: ParameterSpace, used: NDArray[np.integer], moved: Values) -> Values:
    """The displacements of the sheet's welded vertices as those of all (V, 3): doubled ones alike, inner skin by its
    anchors."""
    whole = np.zeros((space.vertex_count, 3))
    whole[used] = moved
    whole = whole[space.welded]
    inner = space.inner
    whole[inner.vertices] = np.einsum("nk,nkc->nc", inner.weights, whole[inner.anchors])
    return whole


def repair_field(
    space: ParameterSpace, taken: ExtractedExpression, shut: Mapping[str, Values | None], /
) -> ExtractedExpression:
    """The expression with lids that meet where a scan's do, and without a fold of the sheet on the generic head; itself
    where nothing is amiss.

    Lids and lips stay as far apart as they are then. Inner skin and parts follow. Under transfer="paper", where nothing
    is repaired, it stays. Position based dynamics (Mueller et al. 2007), as in fold repair.

    space: of the expression; taken: as it was read off; shut: by line, of lids that are to meet,
    how much of it the upper one does at each rung (RUNGS,); None for others.
    """
    if space.transfer == "paper":
        return taken
    ready = prepare_smooth_map(space, generic_face(space))
    worn = wear_on_generic(space, taken)
    if closes_open_jaw(ready, worn):
        return taken
    moved = worn
    for pair in lid_pairs(space):
        upper = shut.get(pair.line.name)
        if upper is not None:
            moved = shut_lids(pair, moved, upper)
    repaired = _repair_folds(ready, moved)
    if repaired is worn:
        return taken
    field = measure_field(space, ready.generic, (repaired - ready.generic)[space.welded])
    return replace(taken, dtheta=field.dtheta, dh=field.dh, ratio=field.ratio)


def wear_on_generic(space: ParameterSpace, taken: ExtractedExpression, /) -> Values:
    """The generic head (V, 3) wearing an expression, metres, by its field alone.

    space: of the expression; taken: the expression.
    """
    generic = prepare_smooth_map(space, generic_face(space)).generic
    return generic + displace_generic(space, compile_expression(space, taken))


def closes_open_jaw(ready: SmoothMap, worn: Values, /) -> bool:
    """Whether the lips of a generic head that wears something (V, 3) lie over each other as without the jaw that they
    are to close.

    ready: the generic head's map; worn (V, 3): metres.
    """
    return any(
        float(((contact.source * contact.line.rungs(worn)).sum(axis=1) - contact.there).mean()) < -OVER
        for contact in ready.contacts
        if contact.line.kind == "lips"
    )


def _repair_folds(ready: SmoothMap, worn: Values) -> Values:
    """The generic head (V, 3) with the fewest folds of all rounds; the same array where none is folded."""
    best = worn
    points = worn.copy()
    folded = find_folds(ready.geometry, worn, ready.generic)
    fewest = int(folded.sum())
    for _ in range(REPAIR_ROUNDS):
        if fewest == 0:
            break
        repair_patch(ready.geometry, points, ready.generic, folded)
        for contact in ready.contacts:
            close_contact(contact, points, worn)
        folded = find_folds(ready.geometry, points, ready.generic)
        if folded.sum() < fewest:
            best = points.copy()
            fewest = int(folded.sum())
    return best


@dataclass(frozen=True, eq=False)
class TakenExpressions:
    """Expressions from the shapes of a stranger's head.

    Attributes
    ----------
    expressions : mapping of ExtractedExpression, by name
        As the shapes are called; any face of the space wears them.
    notes : tuple of str
        Which shapes were left out, and why, and where lids do not close as the scan's, in sentences.
    """

    expressions: Mapping[str, ExtractedExpression]
    notes: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class CarriedShape:
    """What a shape of a scan does to the face that was fitted to it: skin (V, 3), parts (n, 3) by name, metres; shut:
    for each line of lids between which the scan shows an opening at rest, how much of it the upper one shuts at each
    rung (RUNGS,), None where they stay apart."""

    skin: Values
    parts: Mapping[str, Values]
    shut: Mapping[str, Values | None]


def take_expressions(
    space: ParameterSpace, fitted: Fit, scan: Scan, /, *, follow: Follow | None = None
) -> TakenExpressions:
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
    taken = dict[str, ExtractedExpression]()
    notes = list[str]()
    for done, (name, shape) in enumerate(carried.items()):
        if follow:
            follow(done / len(carried), name)
        trouble = explain_unfit(space, fitted.seen, shape.skin, shape.parts)
        if trouble:
            notes.append(f"{name!r} {trouble}, so it is left out.")
            continue
        try:
            bare = extract(space, fitted.face, shape.skin, parts=shape.parts)
        except ValueError as error:
            notes.append(f"{name!r} is left out: {error}.")
            continue
        taken[name] = repair_field(space, bare, shape.shut)
        notes += describe_lids(space, name, wear_on_generic(space, taken[name]), shape.shut)
    if follow:
        follow(1.0, "done")
    return TakenExpressions(MappingProxyType(taken), tuple(notes))


def carry_shapes(space: ParameterSpace, fitted: Fit, scan: Scan, /) -> dict[str, CarriedShape]:
    """What each shape of a scan does to the face that was fitted to it; errors as `take_expressions`.

    space: of the face; fitted: the fit of the scan; scan: with triangles and shapes.
    """
    if scan.triangles is None or not len(scan.triangles):
        raise ValueError("the scan is a cloud of points; expected triangles, along which its shapes can be carried")
    if not scan.shapes:
        raise ValueError("the scan has no shapes; export its head with its blendshapes (morph targets)")
    face = fit(space, fitted.face)
    triangles = np.asarray(scan.triangles)
    skin = face.positions.astype(np.float64)
    points = fitted.placement(scan.positions)
    box = np.stack([skin.min(axis=0), skin.max(axis=0)])
    sampled = sample_mesh(points, triangles, box, AROUND)
    outward = face_outward(sampled, (skin, mesh.normals(skin, space.triangles)))
    if outward is not sampled:
        triangles = triangles[:, ::-1]
    surface = keep_skin(outward, head_zones(space), skin)
    correspondence = correspond(space, skin, points, triangles, surface)
    whole = triangles[whole_sheets(points, triangles, surface)]
    slits = [find_slit(line, skin, points, whole) for line in space.lines if line.kind == "lids"]
    rows = np.unique(triangles[np.unique(surface.triangle)])
    parts = find_parts(space, face, points, triangles, rows)
    turn = fitted.placement.scale * fitted.placement.rotation
    moves = [shape @ turn.T for shape in scan.shapes.values()]
    skins = carry_skin(space, skin, correspondence, moves)
    return {
        name: CarriedShape(
            moved,
            carry_parts(parts, face, points, move),
            {slit.line.name: slit.shut_by(points, move) for slit in slits if slit.known},
        )
        for name, moved, move in zip(scan.shapes, skins, moves, strict=True)
    }
