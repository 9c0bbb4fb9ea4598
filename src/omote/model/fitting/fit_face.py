"""Fits the generic head to a scan whose place is known: a face of certain people with our topology."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike, NDArray

from omote.geometry import mesh
from omote.model.fitting.doubt import Doubt
from omote.model.fitting.fit_doubts import find_doubts
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.landmarks import SEVEN, find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.fitting.scan_skin import keep_skin, may_be_shut
from omote.model.fitting.scan_surface import ScanSurface, face_outward, is_inside_out, sample_cloud, sample_mesh
from omote.model.fitting.shape.eased_corners import ease_corners, ease_folded_corners
from omote.model.fitting.shape.face_closing import close_face
from omote.model.fitting.shape.fitted_eyes import Ball, find_balls, place_balls
from omote.model.fitting.shape.fold_mending import find_folds, mend_folds
from omote.model.fitting.shape.head_zones import HeadZones, head_zones, row_matrix, rung_matrix
from omote.model.fitting.shape.mode_fit import Marks, ModeFit, fit_modes
from omote.model.fitting.shape.plate_fit import Pull, bend, find_lengths, match
from omote.model.sculpting.caricature import find_way_back
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.space.similarity import Similarity, fit_similarity

Values = NDArray[np.float64]
Follow = Callable[[float, str], None]
"""Told how much is done, 0 to 1, and what is being done."""

PEOPLE = "people"
"""The kind of head that most are."""
# The scan is looked at so far around the generic head, metres.
AROUND = 0.03
# Modes go by lids and lips less: they may be open or shut.
OPENINGS = 0.2
# How strong landmarks pull the plate, first and last, and the rungs of lids that are opened.
LANDMARKS, RUNGS = (4.0, 0.02), 40.0
# Farther than this from the scan, metres, a vertex has not been seen.
SEEN = 0.003


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
    zones, marks = head_zones(space), _find_marks(space, placement, landmarks or {})
    tell(0.0, "the surface of the scan")
    surface, turned = _sample(space, scan, placement)
    tell(0.1, "what heads differ by")
    blind = np.where(zones.lids | zones.lips, OPENINGS, 1.0) * zones.weights
    found = fit_modes(space, modes, surface, marks, blind)
    head = found.pose(modes.shape_skin(found.weights))
    skin = keep_skin(surface, zones, head)
    expected = {name: found.pose(points) for name, points in modes.shape_parts(found.weights).items()}
    balls = find_balls(surface, {name: expected[name] for name, part in space.parts.items() if part.eye})
    filled = len(balls) < 2 and may_be_shut(space, skin, head)  # who is made with eyeballs looks
    tell(0.25, "the skin")
    bent = _bend(space, zones, skin, marks, head, filled if shut is None else shut)
    tell(0.7, "eyes and mouth")
    parts = _carry_parts(space, expected, head, bent, balls)
    upright = _set_upright(space, found, parts, bent, bool(landmarks))
    guide = upright(head)
    face = close_face(space, name, guide, upright(bent), {part: upright(points) for part, points in parts.items()})
    folds = find_folds(space, guide, face.positions.astype(np.float64))
    residual, seen = _compare(space, skin, _back(upright)(face.positions))
    doubts = find_doubts(zones, found, residual, len(folds), filled and shut is None, turned)
    tell(1.0, "done")
    return Fit(face, residual, seen, _after(upright, placement), doubts)


def say_nothing(done: float, what: str, /) -> None:
    """Where nobody wants to know the progress."""


def _find_marks(space: ParameterSpace, placement: Similarity, landmarks: Mapping[str, ArrayLike]) -> Marks:
    unknown = [name for name in landmarks if name not in SEVEN]
    if unknown:
        raise ValueError(f"there is no landmark {unknown[0]!r}; expected some of {', '.join(SEVEN)}")
    rows, points = find_landmarks(space), np.zeros((len(landmarks), 3))
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
    space: ParameterSpace, zones: HeadZones, skin: ScanSurface, marks: Marks, head: Values, shut: bool
) -> Values:  # fmt: skip
    """The head (V, 3) bent onto the skin of a scan; shut eyes are opened as far as the generic ones."""
    weights, lengths = zones.weights, find_lengths(skin)
    count, strength = space.vertex_count, np.geomspace(*LANDMARKS, len(lengths))
    pulls = [(Pull(row_matrix(marks.rows, count), marks.points, np.ones(len(marks.rows))), strength)]
    if shut:
        weights = np.where(zones.lids, 0.0, weights)
    for line in space.lines:
        if shut or line.kind == "lips":
            wide = np.ptp(head[line.loop], axis=0)[0] / np.ptp(space.points[line.loop], axis=0)[0]
            rungs = rung_matrix(line, count)
            pull = Pull(rungs, wide * line.rungs(space.points), np.ones(rungs.shape[0]))
            pulls.append((pull, np.full(len(lengths), RUNGS)))
    ease = None if shut else partial(ease_corners, space)
    bent = bend(space, head, skin, weights, pulls, lengths, ease)
    return mend_folds(space, head, ease_folded_corners(space, head, bent) if ease else bent)


def _carry_parts(
    space: ParameterSpace, expected: dict[str, Values], head: Values, bent: Values, balls: Mapping[str, Ball]
) -> dict[str, Values]:  # fmt: skip
    """The parts from where modes put them, as the skin around them went on; the mouth's together, lashes with the lids,
    eyeballs where the scan shows them."""
    parts = dict(expected)
    _, around = find_mouth(space)
    for name, part in space.parts.items():
        if _on_skin(space, name):
            parts[name] = parts[name] + np.einsum("nk,nkc->nc", part.weights, (bent - head)[part.anchors])
        else:
            ring = part.ring if part.eye else around
            parts[name] = fit_similarity(head[ring], bent[ring], np.ones(len(ring)))(parts[name])
    eyes = {name: parts[name] for name, part in space.parts.items() if part.eye}
    return parts | place_balls(space, eyes, bent, balls)


def find_mouth(space: ParameterSpace, /) -> tuple[list[str], NDArray[np.intp]]:
    """The parts in the mouth, by name, and the rows of the skin around them."""
    names = [name for name, part in space.parts.items() if not part.eye and not _on_skin(space, name)]
    return names, np.unique(np.concatenate([space.parts[name].ring for name in names]))


def _on_skin(space: ParameterSpace, name: str) -> bool:
    """Whether a part goes with the skin under it: lashes."""
    part = space.parts[name]
    return bool(part.weights.any()) and not part.follows_jaw


def _set_upright(
    space: ParameterSpace, found: ModeFit, parts: Mapping[str, Values], bent: Values, said: bool
) -> Similarity:  # fmt: skip
    """The turn that undoes the pose's, and the shift that brings the middle of the eyes to the generic ones'; where
    landmarks said that this is a head, as far behind as puts the axis inside of the bent skin."""
    eyes = [name for name, part in space.parts.items() if part.eye]
    turn = found.pose.rotation.T
    there = np.mean([space.parts[name].points.mean(axis=0) for name in eyes], axis=0)
    here = np.mean([parts[name].mean(axis=0) for name in eyes], axis=0)
    upright = Similarity(1.0, turn, there - turn @ here)
    way = find_way_back(space, upright(bent))
    if way is None or (way > 0.0 and not said):
        raise ValueError("what was fitted is too flat or too crooked to be a head; points on eyes, nose and mouth help")
    return Similarity(1.0, turn, upright.shift - [0.0, 0.0, way])


def _compare(space: ParameterSpace, skin: ScanSurface, positions: Values) -> tuple[Values, Values]:
    """Millimetres from the scan (V,), nan where it shows nothing, and how much was seen (V,)."""
    away, seen = skin.measure_distance(positions), np.zeros(len(positions))
    found = match(skin, space, positions, SEEN)
    seen[space.on_sheet] = found.weights[space.on_sheet]
    return np.where(seen > 0.0, 1000.0 * away, np.nan), seen


def _after(last: Similarity, first: Similarity) -> Similarity:
    return Similarity(last.scale * first.scale, last.rotation @ first.rotation, last(first.shift[None])[0])


def _back(way: Similarity) -> Similarity:
    turn = way.rotation.T
    return Similarity(1.0 / way.scale, turn, -turn @ way.shift / way.scale)
