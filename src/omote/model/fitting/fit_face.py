"""Fits the generic head to a scan whose place is known: a face of certain people with our topology, and its doubts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Rows, Values
from omote.geometry import mesh
from omote.model.fitting.doubt import EYES, Doubt
from omote.model.fitting.fitted_eyes import Ball, find_balls, place_balls, seat_lids
from omote.model.fitting.head_zones import HeadZones, head_zones, row_matrix, rung_matrix
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from omote.model.fitting.lids.lid_edges import LidEdges, see_lid_edges
from omote.model.fitting.mode_fit import Marks, ModeFit, fit_modes
from omote.model.fitting.plate_fit import Hold, bend, find_lengths, match
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_skin import keep_skin, may_be_shut, squares_around_eyes
from omote.model.fitting.scan_surface import ScanSurface, face_outward, is_inside_out, sample_cloud, sample_mesh
from omote.model.fitting.skin_repair import (
    ease_creases,
    find_creases,
    find_folds,
    relax_corners,
    repair_corners,
    repair_folds,
    repair_slight_folds,
)
from omote.model.sculpting.caricature import find_way_back
from omote.model.sculpting.socket_depth import fit_lining_at_rest
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity, fit_similarity
from omote.model.transfer.mouth_at_rest import fit_mouth_at_rest

Follow = Callable[[float, str], None]
"""Told how much is done, 0 to 1, and what is being done."""

# Of the face, so much has to be seen, and half of that has to lie within so many millimetres.
LEAST_SEEN = 0.6
NEAR_SCAN = 0.5
# A head farther than so many standard deviations from people, in the mean of the modes, is no person's.
STRANGE = 2.5
PEOPLE = "people"
"""The kind of head that most are."""
# The scan is looked at so far around the generic head, metres.
AROUND = 0.03
# Modes go by lids and lips less: they may be open or shut.
OPENINGS = 0.2
# How strong landmarks pull the plate, first and last, and the rungs of lids that are opened.
LANDMARKS = (4.0, 0.02)
RUNGS = 40.0
# Farther than this from the scan, metres, a vertex has not been seen.
SEEN = 0.003


def find_doubts(
    zones: HeadZones, mode_fit: ModeFit, residual: Values, folds: int, filled: bool, turned: bool, marked: bool, /
) -> tuple[Doubt, ...]:
    """Sentences on a fit, none where it is sure.

    residual (V,): millimetres, nan where nothing was seen; folds: how many triangles are folded; filled: whether the
    scan is closed between its lids and nobody said what that means; turned: whether its triangles face inward; marked:
    whether points were given.

    zones: of the head; mode_fit: its modes.
    """
    face = residual[zones.face]
    seen = np.isfinite(face)
    doubts = list[Doubt]()
    if seen.mean() < LEAST_SEEN:
        doubts.append(Doubt(f"Only {seen.mean():.0%} of the face was seen; the rest is made up."))
    if seen.any() and np.median(face[seen]) > NEAR_SCAN:
        far = f"{np.median(face[seen]):.1f} mm"
        doubts.append(Doubt(f"The face lies {far} from the scan; it may be noisy, or wrongly placed."))
    strange = float(np.sqrt((mode_fit.weights**2).mean()))
    if strange > STRANGE:
        doubts.append(Doubt("The head is unlike those of people; look whether eyes, nose and mouth are in place."))
    if folds:
        places = "one triangle" if folds == 1 else f"{folds} triangles"
        why = "points that were given may be off, or the scan is rough" if marked else "the scan may be rough there"
        doubts.append(Doubt(f"The skin stays folded at {places}: {why}."))
    if filled:
        asked = "The scan is closed between its lids, so they were opened; say whether its eyes are shut."
        doubts.append(Doubt(asked, EYES))
    if turned:
        doubts.append(Doubt("The scan is inside out, so it may be mirrored; look whether its left is its left."))
    return tuple(doubts)


def close_face(space: ParameterSpace, name: str, guide: Values, skin: Values, parts: Mapping[str, Values], /) -> Face:
    """The face of a fitted skin (V, 3) and parts by name; guide (V, 3): a head without folds near it.

    ValueError where it is no face of this space.
    """
    seated = seat_lids(space, skin, {eye: parts[eye] for eye in space.eyes})
    seated = repair_folds(space, guide, seated)
    placed = {part: points.astype(np.float32) for part, points in parts.items()}
    closed = fit_mouth_at_rest(space, seated.astype(np.float32), placed)
    lined = np.asarray(fit_lining_at_rest(space, closed), np.float64)
    face = Face(name, repair_slight_folds(space, guide, lined), placed)
    fit(space, face)  # refuses what is no face of this space
    return face


@dataclass(frozen=True, eq=False)
class Fit:
    """A scan as a face.

    Attributes
    ----------
    face : Face
        With our topology, in the space's frame.
    residual : ndarray, (V,)
        How far each vertex of the skin is from the scan, millimetres; nan where the scan shows nothing.
    seen : ndarray, (V,)
        How much of each vertex comes from the scan, 0 to 1; the rest was made up from what people are like.
    placement : Similarity
        From the scan's own frame and unit to the face's metres.
    doubts : tuple of Doubt
        What should be looked at, in sentences; empty when sure.
    kind : str
        "people", or the name of the cast's face from which one that is no person's began.

    Examples
    --------
    >>> found = omote.fit(cast.space, cast.faces["old"].positions, cast.space.triangles)
    >>> isinstance(found, omote.Fit), found.residual.shape
    (True, (4278,))

    References
    ----------
    K. Arai (1993), section 5.1.
    """

    face: Face
    residual: Values
    seen: Values
    placement: Similarity
    doubts: tuple[Doubt, ...]
    kind: str = PEOPLE


def fit_face(
    space: ParameterSpace, modes: IdentityModes, scan: Scan, placement: Similarity, *,
    landmarks: Mapping[str, ArrayLike] | None = None, name: str = "scan", shut: bool | None = None,
    follow: Follow | None = None,
) -> Fit:  # fmt: skip
    """Fits the generic head to a scan: identity modes first, then a thin plate, then eyes, mouth and folds.

    Parameters
    ----------
    space : ParameterSpace
        The built-in cast's.
    modes : IdentityModes
        What heads differ by.
    scan : Scan
        In its own frame and unit.
    placement : Similarity
        That brings the scan near the generic head, in metres.
    landmarks : mapping of array_like (3,), by name
        Some of the seven named points, in the scan's frame.
    name : str
        The face's.
    shut : bool, optional
        Whether the eyes of the scan are shut; None looks, and says so where it cannot tell.
    follow : callable
        Told the progress.

    Returns
    -------
    Fit
        The face, what it was made of, and doubts.

    Raises
    ------
    ValueError
        On unknown landmarks, where the scan has no surface near the head, and where the fitted skin stays folded.

    References
    ----------
    Amberg, Romdhani and Vetter (2007), "Optimal step nonrigid ICP algorithms for surface registration"; Blanz and
    Vetter (1999).
    """
    refuse_other_topology(space, modes)
    tell = follow or say_nothing
    zones = head_zones(space)
    marks = _find_marks(space, placement, landmarks or {})
    tell(0.0, "the surface of the scan")
    surface, turned = _sample(space, scan, placement)
    tell(0.1, "what heads differ by")
    blind = np.where(zones.lids | zones.lips, OPENINGS, 1.0) * zones.weights
    modes_fit = fit_modes(space, modes, surface, marks, blind)
    plain = modes_fit.pose(modes.skin)
    head = ease_creases(space, plain, modes_fit.pose(modes.shape_skin(modes_fit.weights)))
    skin = keep_skin(surface, zones, head)
    expected = {name: modes_fit.pose(points) for name, points in modes.shape_parts(modes_fit.weights).items()}
    balls = find_balls(surface, {name: expected[name] for name in space.eyes})
    edges = see_lid_edges(space, scan, placement, skin)
    seen_skin = squares_around_eyes(space, skin, head) if edges is None else (edges.points, edges.triangles)
    filled = len(balls) < 2 and may_be_shut(space, seen_skin, head)  # who is made with eyeballs looks
    tell(0.25, "the skin")
    closed = filled if shut is None else shut
    bent = _bend(space, zones, skin, marks, head, closed, None if closed else edges)
    tell(0.7, "eyes and mouth")
    parts = _carry_parts(space, expected, head, bent, balls)
    upright = set_upright(space, modes_fit.pose, parts, bent, bool(landmarks))
    guide = upright(head)
    face = close_face(space, name, guide, upright(bent), {part: upright(points) for part, points in parts.items()})
    folds = _find_all_folds(space, (guide, upright(plain)), face)
    residual, seen = _compare(space, skin, upright.back(face.positions))
    doubts = find_doubts(zones, modes_fit, residual, len(folds), filled and shut is None, turned, bool(landmarks))
    tell(1.0, "done")
    return Fit(face, residual, seen, _after(upright, placement), doubts)


def _find_all_folds(space: ParameterSpace, guides: tuple[Values, Values], face: Face) -> Rows:
    """The triangles of a face that are folded against the guide (V, 3) of its fit, or lie on a neighbour as they do not
    on the plain head (V, 3), where that guide may be folded itself."""
    guide, plain = guides
    skin = face.positions.astype(np.float64)
    return np.union1d(find_folds(space, guide, skin), find_creases(space, plain, skin))


def say_nothing(done: float, what: str, /) -> None:
    """Tells nobody of the progress: where nobody wants to know it.

    done: 0 to 1; what: what is being done.
    """


def _find_marks(space: ParameterSpace, placement: Similarity, landmarks: Mapping[str, ArrayLike]) -> Marks:
    unknown = [name for name in landmarks if name not in SEVEN]
    if unknown:
        raise ValueError(f"there is no landmark {unknown[0]!r}; expected some of {', '.join(SEVEN)}")
    rows = find_landmarks(space)
    points = np.zeros((len(landmarks), 3))
    for at, (name, point) in enumerate(landmarks.items()):
        points[at] = mesh.validate_points(np.reshape(point, (1, -1)), name=f"landmark {name!r}")[0]
    return Marks(np.array([rows[name] for name in landmarks], np.intp), placement(points))


def _sample(space: ParameterSpace, scan: Scan, placement: Similarity) -> tuple[ScanSurface, bool]:
    """The surface of a scan facing outward, and whether its triangles faced inward."""
    points = placement(scan.positions)
    box = np.stack([space.points.min(axis=0), space.points.max(axis=0)])
    outside = (space.points, mesh.normals(space.points, space.triangles))
    if scan.triangles is not None and len(scan.triangles):
        sampled = sample_mesh(points, scan.triangles, box, AROUND)
        return face_outward(sampled, outside), is_inside_out(sampled, outside)
    return sample_cloud(points, outside, box, AROUND), False


def _bend(
    space: ParameterSpace, zones: HeadZones, skin: ScanSurface, marks: Marks, head: Values, shut: bool,
    edges: LidEdges | None,
) -> Values:  # fmt: skip
    """The head (V, 3) bent onto the skin of a scan, its lids to their edges; shut eyes are opened as far as the generic
    ones."""
    weights = zones.weights
    lengths = find_lengths(skin)
    count = space.vertex_count
    strength = np.geomspace(*LANDMARKS, len(lengths))
    pulls = [(Hold(row_matrix(marks.rows, count), marks.points, np.ones(len(marks.rows))), strength)]
    if shut:
        weights = np.where(zones.lids, 0.0, weights)
    for line in space.lines:
        if shut or line.kind == "lips":
            wide = np.ptp(head[line.loop], axis=0)[0] / np.ptp(space.points[line.loop], axis=0)[0]
            rungs = rung_matrix(line, count)
            pull = Hold(rungs, wide * line.rungs(space.points), np.ones(rungs.shape[0]))
            pulls.append((pull, np.full(len(lengths), RUNGS)))
    relax = None if shut else partial(relax_corners, space)
    bent = bend(space, head, skin, weights, pulls, lengths, relax, edges.find_pulls if edges else None)
    return repair_folds(space, head, repair_corners(space, head, bent) if relax else bent)


def _carry_parts(
    space: ParameterSpace, expected: dict[str, Values], head: Values, bent: Values, balls: Mapping[str, Ball]
) -> dict[str, Values]:
    """The parts from where modes put them, as the skin around them went on; the mouth's together, lashes with the lids,
    eyeballs where the scan shows them."""
    parts = dict(expected)
    _, around = find_mouth(space)
    for name, part in space.parts.items():
        if part.follows_skin:
            parts[name] = parts[name] + np.einsum("nk,nkc->nc", part.weights, (bent - head)[part.anchors])
        else:
            ring = part.ring if part.eye else around
            parts[name] = fit_similarity(head[ring], bent[ring], np.ones(len(ring)))(parts[name])
    return parts | place_balls(space, {name: parts[name] for name in space.eyes}, bent, balls)


def find_mouth(space: ParameterSpace, /) -> tuple[list[str], Rows]:
    """The parts in the mouth, by name, and the rows of the skin around them."""
    names = [name for name, part in space.parts.items() if not part.eye and not part.follows_skin]
    return names, np.unique(np.concatenate([space.parts[name].ring for name in names]))


def set_upright(
    space: ParameterSpace, pose: Similarity, parts: Mapping[str, Values], bent: Values, said: bool, /
) -> Similarity:
    """The turn that undoes a pose's, and the shift that brings the middle of the eyes to the generic ones'; where it is
    said that this is a head, as far behind as puts the axis inside of the skin.

    space: of the head; pose: from the modes' frame; parts: points (n, 3) by name, bent: the skin (V, 3), metres; said:
    whether landmarks say that it is a head. ValueError where it cannot be one.
    """
    turn = pose.rotation.T
    there = np.mean([part.points.mean(axis=0) for part in space.eyes.values()], axis=0)
    here = np.mean([parts[name].mean(axis=0) for name in space.eyes], axis=0)
    upright = Similarity(1.0, turn, there - turn @ here)
    way = find_way_back(space, upright(bent))
    if way is None or (way > 0.0 and not said):
        raise ValueError("what was fitted is too flat or too crooked to be a head; points on eyes, nose and mouth help")
    return Similarity(1.0, turn, upright.shift - [0.0, 0.0, way])


def _compare(space: ParameterSpace, skin: ScanSurface, positions: Values) -> tuple[Values, Values]:
    """Millimetres from the scan (V,), nan where it shows nothing, and how much was seen (V,)."""
    away = skin.measure_distance(positions)
    seen = np.zeros(len(positions))
    matches = match(skin, space, positions, SEEN)
    seen[space.on_sheet] = matches.weights[space.on_sheet]
    return np.where(seen > 0.0, 1000.0 * away, np.nan), seen


def _after(last: Similarity, first: Similarity) -> Similarity:
    return Similarity(last.scale * first.scale, last.rotation @ first.rotation, last(first.shift[None])[0])
