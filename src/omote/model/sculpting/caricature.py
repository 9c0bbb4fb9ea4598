"""Caricature: what distinguishes a face from the generic one, drawn less or more than it is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu
from scipy.spatial.distance import cdist
from scipy.spatial.transform import Rotation

from omote.arrays import Mask, Triangles, Values
from omote.geometry import mesh
from omote.geometry.laplacian import smoothing_matrix
from omote.geometry.proximity import nearest_triangles
from omote.geometry.ramp import smooth_ramp
from omote.model.sculpting.regions import fit_with_lids, vertex_areas
from omote.model.space.eye_socket import ball_heights, radius_of, set_ball_heights
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.head_regions import eye_frame
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space
from omote.model.space.skin_sheet import refuse_axis_outside
from omote.model.transfer.mouth_bag import find_mouth_bag

# Stretches stay within these factors of one in their logarithm per unit of growth: a wrinkle is no form.
_MOST = np.log(3.0)
# A turn grows by as much as it is up to the first, radians, and never by more than the second: a cat's ears, which sit
# a radian from where people have theirs, would fold over its head. Nine tenths of any person turn by less than 0.2.
_TURNS_WHOLE = 0.3
_TURNS_MOST = 0.45
# How hard the middle of the head holds its place, so that the sum of all gradients has one solution.
_HOLD = 1e-9
# Edge of a cell in which triangles are averaged together, in bells.
_CELL = 0.5
# Rounds of pulling at most.
_PULL_ROUNDS = 30


def extrapolate(generic: Values, face: Values, triangles: Triangles, amount: float, bell: float, /) -> Values:
    """Extrapolates a face (V, 3): what turns and stretches it from the generic one (V, 3) is applied again, times
    amount.

    triangles: rows (F, 3) of vertices.

    Each triangle's deformation gradient (Sumner and Popovic 2004) is a rotation and a stretch; the logarithms of both,
    averaged over a bell of that width in metres, times amount are its growth, that of a rotation within bounds, and the
    positions whose gradients come nearest to all grown ones follow (Yu et al. 2004). Amount zero gives the face. Its
    middle goes on straight ahead.
    """
    rotation, stretch = _turn_and_stretch(generic, face, triangles)
    turn = _average(generic, triangles, Rotation.from_matrix(rotation).as_rotvec(), bell)
    stretch = _average(generic, triangles, stretch, bell)
    # The stretch is known in the generic face's frame; the face's own rotation brings it to where it acts.
    acting = rotation @ _exponential(amount * stretch) @ rotation.transpose(0, 2, 1)
    wanted = Rotation.from_rotvec(_bounded(amount * turn)).as_matrix() @ acting @ _frames(face, triangles)[:, :, :2]
    result = _integrate_edges(face, triangles, wanted)
    middle = _middle(face, triangles) + amount * (_middle(face, triangles) - _middle(generic, triangles))
    return result + middle - _middle(result, triangles)


def find_folds(face: Values, positions: Values, triangles: Triangles, /) -> Mask:
    """The triangles (T,) whose normals look against those that they have on the face.

    positions: (V, 3), metres, where they are now.
    """
    normals = (np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]) for p in (face[triangles], positions[triangles]))
    here, there = normals
    return (here * there).sum(axis=1) < 0.0


def repair_folds(face: Values, positions: Values, triangles: Triangles, /) -> Values:
    """Smooths positions (V, 3) where triangles are turned over against the face, by the mean of their one-rings, as
    little as repairs them, in a limited number of rounds; unchanged where nothing is folded."""
    result = positions.copy()
    mean = smoothing_matrix(triangles, len(positions))
    for _ in range(_PULL_ROUNDS):
        bad = find_folds(face, result, triangles)
        if not bad.any():
            break
        rows = np.unique(triangles[bad])
        result[rows] += 0.5 * ((mean @ result)[rows] - result[rows])
    return result


def _frames(points: Values, triangles: Triangles) -> Values:
    """Two edges and a normal as long as they are: (T, 3, 3), in columns."""
    a, b, c = points[triangles].transpose(1, 0, 2)
    normal = np.cross(b - a, c - a)
    normal /= np.sqrt(np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-30))
    return np.stack([b - a, c - a, normal], axis=2)


def _turn_and_stretch(generic: Values, face: Values, triangles: Triangles) -> tuple[Values, Values]:
    """Rotations and the logarithms of the stretches that come before them, (T, 3, 3) both."""
    there = _frames(generic, triangles)
    here = _frames(face, triangles)
    left, sizes, right = np.linalg.svd(here @ np.linalg.inv(there))
    sizes = np.clip(np.log(np.maximum(sizes, 1e-9)), -_MOST, _MOST)
    stretch: Values = (right.transpose(0, 2, 1) * sizes[:, None]) @ right
    return left @ right, stretch


def _bounded(turns: Values) -> Values:
    """Turns (T, 3), rotation vectors, as they are up to a bound and then less and less more, without a corner."""
    angle = np.linalg.norm(turns, axis=1, keepdims=True)
    over = np.maximum(angle - _TURNS_WHOLE, 0.0)
    room = _TURNS_MOST - _TURNS_WHOLE
    bounded: Values = turns * (np.minimum(angle, _TURNS_WHOLE) + room * over / (room + over)) / np.maximum(angle, 1e-12)
    return bounded


def _exponential(logs: Values) -> Values:
    sizes, axes = np.linalg.eigh(logs)
    return (axes * np.exp(sizes)[:, None]) @ axes.transpose(0, 2, 1)


def _average(points: Values, triangles: Triangles, values: Values, bell: float) -> Values:
    """The mean of what triangles have, (T, ...), under a bell around each; they count in cells of half a bell."""
    middles = points[triangles].mean(axis=1)
    area = mesh.areas(points, triangles)
    _, cell = np.unique(np.floor(middles / (_CELL * bell)), axis=0, return_inverse=True)
    cell = cell.reshape(-1)
    total = sparse.csr_array((area, (cell, np.arange(len(cell)))), shape=(int(cell.max()) + 1, len(cell)))
    sums = np.asarray(total.sum(axis=1))[:, None]
    square = cdist(middles, total @ middles / sums, "sqeuclidean") / (2.0 * bell * bell)
    weight = np.exp(square.min(axis=1, keepdims=True) - square)
    mean: Values = weight @ (total @ values.reshape(len(values), -1)) / (weight @ sums)
    return mean.reshape(values.shape)


def _integrate_edges(face: Values, triangles: Triangles, wanted: Values) -> Values:
    """The positions (V, 3) whose edges come nearest to the wanted ones (T, 3, 2), least squares in the face's areas."""
    a, b, c = face[triangles].transpose(1, 0, 2)
    edges = np.stack([b - a, c - a], axis=2)
    inverse = np.linalg.pinv(edges)  # (T, 2, 3): slopes of the two corners' shares over the face
    slopes = np.concatenate([-inverse.sum(axis=1, keepdims=True), inverse], axis=1)
    area = mesh.areas(face, triangles)
    rows = np.repeat(triangles, 3, axis=1).ravel()
    columns = np.tile(triangles, 3).ravel()
    stiff = area[:, None, None] * slopes @ slopes.transpose(0, 2, 1)
    matrix = sparse.csc_array((stiff.ravel(), (rows, columns)), shape=(len(face), len(face)))
    pull = area[:, None, None] * slopes @ (inverse.transpose(0, 2, 1) @ wanted.transpose(0, 2, 1))
    right = np.zeros_like(face)
    np.add.at(right, triangles.ravel(), pull.reshape(-1, 3))
    held = _HOLD * matrix.diagonal().mean()
    solver = splu(matrix + held * sparse.eye_array(len(face), format="csc"))
    return solver.solve(right + held * face)


def _middle(points: Values, triangles: Triangles) -> Values:
    area = mesh.areas(points, triangles)
    return (area[:, None] * points[triangles].mean(axis=1)).sum(axis=0) / area.sum()


# The bell under which stretches are averaged, in distances between the eyes.
_BELL = 0.3
# Along the mesh from the lips, metres: up to the first the mouth bag grows as the skin does, from the second on it is
# carried as the teeth are.
_BAG_METRES = (0.001, 0.028)
# From the first to the second it comes to lie as deep behind the skin as the face's own, as its tongue does, up to
# _DEEPEST, metres; what is drawn in for that is averaged over so many rings.
_DEEP_METRES = (0.03, 0.05)
_DEEPEST = 0.01
_SPREAD_ROUNDS = 3
TONGUE = "tongue"
BEHIND = 0.012
"""The back of a caricature's head lies at least so far behind the axis, metres."""
# How far the back may be moved, in which steps that is tried, and how exactly it is found, metres.
_FARTHEST = 0.06
_STEP = 0.005
_EXACT = 1e-4
MOST_AMOUNT = 3.0
"""Of caricature: as far as people still read a face."""


def check_amount(amount: float) -> None:
    """Raises ValueError on an amount of caricature that is out of range, or no number."""
    if not 0.0 <= amount <= MOST_AMOUNT:
        raise ValueError(
            f"a caricature's amount is {amount!r}; expected a number from 0 (the generic face) to {MOST_AMOUNT:g}, 1 "
            "for the face itself, such as 1.5"
        )


def caricature(space: ParameterSpace, face: Face, amount: float, /) -> Face:
    """What distinguishes a face from the generic one, times amount: 0 the generic face, 1 the face, 2 twice itself.

    Up to one it is the linear mix; beyond, only the smooth form grows, by its turns and stretches, so that wrinkles and
    lids stay what they are and nothing folds.

    Parameters
    ----------
    space : ParameterSpace
        The space of the face.
    face : Face
        Who is drawn.
    amount : float
        How much of it.

    Returns
    -------
    Face
        Named after face and amount: "kaori_150".

    Raises
    ------
    ValueError
        On an amount that is not from 0 to 3, or that tears the face.

    Examples
    --------
    >>> omote.caricature(cast.space, cast.faces["kaori"], 1.5).name
    'kaori_150'

    References
    ----------
    docs/sculpts.md, "Mixes and caricature".
    """
    refuse_no_space(space)
    if isinstance(amount, bool) or not isinstance(amount, int | float | np.number):
        raise TypeError(f"a caricature's amount is {amount!r}; expected a number such as 1.5")
    check_amount(amount)
    fitted = fit(space, face)
    within = min(amount, 1.0)
    beyond = max(amount - 1.0, 0.0)
    name = f"{face.name}_{100 * amount:.0f}"
    skin = space.points + within * (fitted.positions - space.points)
    parts = {name: part.points + within * (fitted.parts[name] - part.points) for name, part in space.parts.items()}
    if beyond == 0.0:
        return fit_with_lids(space, name, skin, parts, {}, face.gains)
    grown = extrapolate(space.points, skin, space.triangles, beyond, _BELL * eye_frame(space)[1])
    further = stand_around_axis(space, grown, f"{face.name} drawn {amount:g} times")
    for part in space.parts.values():
        moves = _bell(space, further - skin, part.points)
        parts[part.name] = (
            _extrapolate_ball(parts[part.name], moves, part.points, beyond) if part.eye else parts[part.name] + moves
        )
    further = _carry_bag(space, skin, further)
    if TONGUE in parts:
        mean = smoothing_matrix(space.parts[TONGUE].triangles, len(parts[TONGUE]))
        depths = _depths(space, skin, fitted.parts[TONGUE].astype(np.float64))[0]
        parts[TONGUE] = _keep_depths(space, further, parts[TONGUE], depths, mean)
    wanted = {eye: ball_heights(fitted.positions, fitted.parts[eye]) for eye in space.eyes}
    lidded = set_ball_heights(further, parts, wanted)
    return fit_with_lids(space, name, repair_folds(skin, lidded, space.skin_triangles), parts, {}, face.gains)


def stand_around_axis(space: ParameterSpace, skin: Values, what: str, /) -> Values:
    """The skin (V, 3), moved back as little as puts the cylinder's axis BEHIND metres inside it; itself where it is.

    space: the space of the generic head.

    A head that is smaller than the generic one has its back nearer to the eyes, twice as near when drawn twice. Raises
    ValueError, which names what was drawn, where no place is far enough back.
    """
    way = find_way_back(space, skin)
    if way is None:
        raise ValueError(
            f"{what} itself is too flat or too crooked to stand around the axis of the head; expected a smaller amount"
        )
    return skin - [0.0, 0.0, way] if way else skin


def find_way_back(space: ParameterSpace, skin: Values, /) -> float | None:
    """The least way back, metres, that puts the cylinder's axis BEHIND metres inside a skin (V, 3): 0 where it is; None
    where no place is far enough back.

    space: the space of the generic head.
    """
    if _is_around_axis(space, skin, 0.0):
        return 0.0
    # A head that is bent stands around the axis here and there on the way back: the first place counts.
    steps = _STEP * np.arange(1, round(_FARTHEST / _STEP) + 1)
    farthest = next((float(step) for step in steps if _is_around_axis(space, skin, float(step))), None)
    if farthest is None:
        return None
    nearest = farthest - _STEP
    while farthest - nearest > _EXACT:
        middle = 0.5 * (nearest + farthest)
        nearest, farthest = (nearest, middle) if _is_around_axis(space, skin, middle) else (middle, farthest)
    return farthest


def _is_around_axis(space: ParameterSpace, skin: Values, back: float) -> bool:
    """Whether the axis and a line BEHIND metres behind it run inside of a skin (V, 3) that is moved back, metres."""
    axis = space.cylinder
    try:
        for behind in (0.0, BEHIND):
            refuse_axis_outside(skin, space.location_triangles, replace(axis, z=axis.z + back - behind))
    except ValueError:
        return False
    return True


def _extrapolate_ball(ball: Values, moves: Values, generic: Values, beyond: float) -> Values:
    """An eyeball (n, 3) that goes with its surroundings and grows once more as it did from the generic one."""
    size = (radius_of(ball) / radius_of(generic)) ** beyond
    middle = ball.mean(axis=0)
    return middle + moves.mean(axis=0) + size * (ball - middle)


def _carry_bag(space: ParameterSpace, skin: Values, further: Values) -> Values:
    """The skin (V, 3) grown to further (V, 3), the deep end of its mouth bag as far on as the teeth's surroundings are:
    the bag's own turns and stretches, added up over its length, took the dog's out of its crown."""
    bag = find_mouth_bag(space)
    if bag is None:
        return further
    deep = smooth_ramp(*_BAG_METRES, bag.distance)[:, None]
    before = skin[bag.vertices]
    grown = further[bag.vertices]
    carried = before + _bell(space, further - skin, space.points[bag.vertices])
    mean = smoothing_matrix(bag.triangles, len(skin))[bag.vertices][:, bag.vertices]
    depths = smooth_ramp(*_DEEP_METRES, bag.distance) * _depths(space, skin, before)[0]
    kept = _keep_depths(space, further, grown + deep * (carried - grown), depths, mean)
    rows = np.flatnonzero(bag.rows >= 0)
    result = further.copy()
    result[space.inner.vertices[rows]] = kept[bag.rows[rows]]
    return result


def _depths(space: ParameterSpace, skin: Values, points: Values) -> tuple[Values, Values]:
    """How far points (n, 3) that are inside lie behind the nearest skin of (V, 3), (n,) metres, and the ways inward."""
    corners = skin[space.location_triangles]
    away, at = nearest_triangles(corners, np.ascontiguousarray(points))
    return away, -mesh.unit_normals(corners[at])


def _keep_depths(space: ParameterSpace, skin: Values, points: Values, depths: Values, mean: sparse.csr_array) -> Values:
    """Points (n, 3) drawn in until they lie as deep behind the skin (V, 3) as depths (n,) say, up to _DEEPEST, and
    what is around them with them: a head turns what is in it out of a throat that turns less.

    mean: (n, n), of each point's neighbours.
    """
    wanted = np.minimum(depths, _DEEPEST)
    result = points.copy()
    for _ in range(_PULL_ROUNDS):
        away, inward = _depths(space, skin, result)
        missing = np.maximum(wanted - away, 0.0)
        if missing.max() < _EXACT:
            break
        push = missing[:, None] * inward
        for _ in range(_SPREAD_ROUNDS):
            push = mean @ push
        result += push
    return result


def _bell(space: ParameterSpace, difference: Values, where: Values) -> Values:
    """The sheet's difference (V, 3), each point's the mean under a bell around it."""
    width = _BELL * eye_frame(space)[1]
    sheet = np.unique(space.skin_triangles)
    square = cdist(where, space.points[sheet], "sqeuclidean") / (2.0 * width * width)
    bell = vertex_areas(space)[sheet] * np.exp(square.min(axis=1, keepdims=True) - square)
    return bell @ difference[sheet] / bell.sum(axis=1, keepdims=True)
