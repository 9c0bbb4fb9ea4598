"""Sculpts: faces made by moving a few control points of the generic head; the rest follows a radial-basis warp."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from omote.arrays import Values
from omote.geometry import mesh
from omote.geometry.laplacian import smoothing_matrix
from omote.model.cast import Look
from omote.model.sculpting.regions import fit_with_lids
from omote.model.space.eye_socket import ball_heights, fall_off, move_ball
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.gain import Gain, validate_gains
from omote.model.space.parameter_space import ParameterSpace, refuse_no_space

MOST_ROUNDS = 200
# Up to this share of its reach a brush works in full; from there it works less and less.
_CORE = 0.5


@dataclass(frozen=True)
class Brush:
    """Smooths the skin within `reach` metres of a point of the generic head, `rounds` times, softly at its rim.

    Raises ValueError on a reach that is not above zero and on rounds that are no whole number from 1 to MOST_ROUNDS.
    """

    at: tuple[float, float, float]
    reach: float
    rounds: int

    def __post_init__(self) -> None:
        if len(self.at) != 3 or not np.isfinite(self.at).all():
            raise ValueError(f"a brush is at {self.at!r}; expected three finite numbers, metres")
        if not 0.0 < self.reach < np.inf:
            raise ValueError(f"a brush reaches {self.reach!r} m; expected a distance above zero")
        if isinstance(self.rounds, bool) or not isinstance(self.rounds, int) or not 1 <= self.rounds <= MOST_ROUNDS:
            raise ValueError(
                f"a brush goes {self.rounds!r} rounds; expected a whole number of them, from 1 to {MOST_ROUNDS}"
            )

    def strength(self, points: Values) -> Values:
        """How much of a round reaches each point (n, 3) of the generic head: (n,), 1 in the core, 0 beyond."""
        away = np.linalg.norm(points - self.at, axis=1) / self.reach
        return fall_off((away - _CORE) / (1.0 - _CORE))


def apply_brushes(
    space: ParameterSpace, skin: Values, brushes: Sequence[Brush], /, *, symmetric: bool = True
) -> Values:
    """Smooths the skin (V, 3) under each brush by the mean of its one-rings (Laplacian smoothing); the rest stays.

    space: the space of the generic head; brushes: in their order.

    symmetric: a brush works at its mirror image too.
    """
    result = skin.copy()
    mean = smoothing_matrix(space.skin_triangles, space.vertex_count)
    mirror = np.array([-1.0, 1.0, 1.0])
    for brush in brushes:
        strength = brush.strength(space.points)
        if symmetric:
            strength = np.maximum(strength, brush.strength(space.points * mirror))
        for _ in range(brush.rounds):
            result += strength[:, None] * (mean @ result - result)
    return result


Kernel = Literal["biharmonic", "triharmonic"]
KERNELS: tuple[Kernel, ...] = get_args(Kernel)

MOUTH = ("teeth_upper", "teeth_lower", "tongue")
FARTHEST = 0.06
"""How far from the generic head a control point may lie, metres."""
_NEAREST = 1e-4  # Two control points closer than this, metres, would tear the skin between them.
_EXACT = 1e-7  # What a point on the midline may be off it, and how exactly control points arrive, metres.
# Lengths are counted in this unit while solving, so that the affine part and the kernel are of one size.
WARP_UNIT = 0.05


@dataclass(frozen=True, eq=False)
class Sculpt:
    """Control points of the generic head and where they go.

    Parameters
    ----------
    name : str
        The face's.
    points, moves : array_like, (n, 3)
        Where the points are and how far they go, metres.
    symmetric : bool
        A point beside the midline stands for its mirror image too, one on it stays on it.
    kernel : {"triharmonic", "biharmonic"}
        |r|^3: smooth; |r|: lively, a little pointed at the points.
    look : Look
        The face's colours and traits.
    base : mapping of float, by the name of a face
        Faces whose difference from the generic one is added first, by weight.
    teeth : float
        The scale of teeth and tongue about their middle, so that they stay behind the lips; 0.5 to 1.5.
    brushes : tuple of Brush
        Where the skin is smoothed.
    gains : tuple of Gain
        In which strength the face answers expressions, region by region.

    Raises
    ------
    ValueError
        On points that decide no shape or contradict each other.

    Examples
    --------
    >>> points = np.array([[0, -0.035, 0.168], [0.08, 0, 0.04], [0, 0.12, 0.04], [0, -0.13, -0.02]])  # nose, ear, ...
    >>> omote.Sculpt("long_nose", points, [[0, 0, 0.03], [0, 0, 0], [0, 0, 0], [0, 0, 0]]).kernel
    'triharmonic'

    References
    ----------
    docs/sculpts.md; Duchon (1977); Carr et al. (2001).
    """

    name: str
    points: Values
    moves: Values
    symmetric: bool = True
    kernel: Kernel = "triharmonic"
    look: Look = field(default_factory=Look)
    base: Mapping[str, float] = field(default_factory=dict)
    teeth: float = 1.0
    brushes: tuple[Brush, ...] = ()
    gains: tuple[Gain, ...] = ()

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name:
            raise ValueError(f"a sculpt is named {self.name!r}; expected a text that is not empty")
        if self.kernel not in KERNELS:
            raise ValueError(
                f"the kernel of sculpt {self.name!r} is {self.kernel!r}; expected one of "
                + ", ".join(map(repr, KERNELS))
            )
        if not 0.5 <= self.teeth <= 1.5:
            raise ValueError(f"teeth of sculpt {self.name!r} is {self.teeth!r}; expected a scale from 0.5 to 1.5")
        for attribute in ("points", "moves"):
            rows = mesh.validate_points(getattr(self, attribute), name=f"{attribute} of sculpt {self.name!r}")
            object.__setattr__(self, attribute, mesh.freeze(rows))
        object.__setattr__(self, "base", MappingProxyType({name: float(w) for name, w in self.base.items()}))
        object.__setattr__(self, "gains", validate_gains(self.gains, f"sculpt {self.name!r}"))
        _refuse_weights(self)
        _refuse_contradiction(self)


def warp(sculpt: Sculpt, /) -> Callable[[Values], Values]:
    """The map of space that a sculpt stands for: points (n, 3) metres to where they go, exact at the control points.

    A radial basis with an affine part (Duchon 1977; Carr et al. 2001): of all maps through the control points the one
    that bends least. Raises ValueError where the points lie in one plane.
    """
    points, moves = _both_sides(sculpt)
    if not _spread(points):
        raise ValueError(
            f"the {len(points)} control points of sculpt {sculpt.name!r} lie in one plane; expected at least four that "
            "do not: add one behind or beside them"
        )
    answer = np.linalg.solve(_system(points, sculpt.kernel), np.concatenate([moves, np.zeros((4, 3))]))

    def move(where: Values) -> Values:
        return where + _columns(points, sculpt.kernel, where) @ answer

    if not np.abs(move(points) - points - moves).max() < _EXACT:
        raise ValueError(
            f"the control points of sculpt {sculpt.name!r} could not be met to {_EXACT} m; "
            "expected points that are apart: join those that nearly touch"
        )
    return move


def sculpted(space: ParameterSpace, sculpt: Sculpt, faces: Mapping[str, Face] | None = None, /) -> Face:
    """The face that a sculpt makes: skin and parts are carried by its map, eyeballs stay round, lids stay on them.

    Parameters
    ----------
    space : ParameterSpace
        The generic head that the points are given on.
    sculpt : Sculpt
        The points and moves.
    faces : mapping of Face, by name, optional
        Those that its base may name.

    Returns
    -------
    Face
        Exact at the control points (to 1e-7 m, before lids are laid on the eyeballs).

    Raises
    ------
    ValueError
        Where a control point is far from the head, the base is unknown or the result is no face of this space.

    Examples
    --------
    >>> from pathlib import Path
    >>> noh = omote.read_sculpt(Path(omote.__file__).parent / "builtin" / "sculpts" / "noh.toml")
    >>> omote.sculpted(cast.space, noh, cast.faces).name
    'noh'

    References
    ----------
    docs/sculpts.md, "What happens"; Duchon (1977): thin-plate splines in space.
    """
    refuse_no_space(space)
    if not isinstance(sculpt, Sculpt):
        raise TypeError(f"the sculpt is a {type(sculpt).__name__}; expected an omote.Sculpt, as read_sculpt gives")
    _refuse_far(space, sculpt)
    move = warp(sculpt)
    skin, parts = _base(space, sculpt, faces or {})
    wanted = {name: ball_heights(space.points, part.points) for name, part in space.eyes.items()}
    skin += move(space.points) - space.points
    skin = apply_brushes(space, skin, sculpt.brushes, symmetric=sculpt.symmetric)
    for name, part in space.parts.items():
        there = move(part.points)
        parts[name] = move_ball(parts[name], part.points, there) if part.eye else parts[name] + there - part.points
    _scale_mouth(parts, sculpt.teeth)
    return fit_with_lids(space, sculpt.name, skin, parts, wanted, sculpt.gains)


def _scale_mouth(parts: dict[str, Values], scale: float) -> None:
    mouth = [name for name in MOUTH if name in parts]
    if mouth:
        middle = np.concatenate([parts[name] for name in mouth]).mean(axis=0)
        for name in mouth:
            parts[name] = middle + scale * (parts[name] - middle)


def _base(space: ParameterSpace, sculpt: Sculpt, faces: Mapping[str, Face]) -> tuple[Values, dict[str, Values]]:
    skin = np.array(space.points)
    parts = {name: np.array(part.points) for name, part in space.parts.items()}
    for name, weight in sculpt.base.items():
        if name not in faces:
            raise ValueError(
                f"sculpt {sculpt.name!r} starts from a face {name!r}; expected one of {', '.join(faces) or 'none'}"
            )
        fitted = fit(space, faces[name])
        skin += weight * (fitted.positions - space.points)
        for part, points in parts.items():
            points += weight * (fitted.parts[part] - space.parts[part].points)
    return skin, parts


def _local(points: Values, where: Values) -> Values:
    return (where - points.mean(axis=0)) / WARP_UNIT


def _spread(points: Values) -> bool:
    """Whether some four of the points lie in no plane."""
    affine = np.column_stack([np.ones(len(points)), _local(points, points)])
    return len(points) >= 4 and bool(np.linalg.matrix_rank(affine, tol=1e-3) == 4)


def _system(points: Values, kernel: Kernel) -> Values:
    """What maps a map's coefficients (n + 4) to the moves of its control points; below them, four zeros."""
    centres = _local(points, points)
    affine = np.column_stack([np.ones(len(points)), centres])
    return np.block([[_kernel(kernel, centres, centres), affine], [affine.T, np.zeros((4, 4))]])


def _columns(points: Values, kernel: Kernel, where: Values) -> Values:
    """What a map's coefficients are weighed with at each place: (m, n + 4)."""
    local = _local(points, where)
    centres = _local(points, points)
    return np.column_stack([_kernel(kernel, local, centres), np.ones(len(local)), local])


def _kernel(kernel: Kernel, where: Values, centres: Values) -> Values:
    distance: Values = cdist(where, centres)
    return distance if kernel == "biharmonic" else distance**3


def _both_sides(sculpt: Sculpt) -> tuple[Values, Values]:
    if not sculpt.symmetric:
        return sculpt.points, sculpt.moves
    beside = np.abs(sculpt.points[:, 0]) > _EXACT
    mirror = np.array([-1.0, 1.0, 1.0])
    return (
        np.concatenate([sculpt.points, sculpt.points[beside] * mirror]),
        np.concatenate([sculpt.moves, sculpt.moves[beside] * mirror]),
    )


def _refuse_weights(sculpt: Sculpt) -> None:
    for name, weight in sculpt.base.items():
        if not np.isfinite(weight):
            raise ValueError(f"sculpt {sculpt.name!r} starts from {name!r} by {weight!r}; expected a finite weight")


def _refuse_contradiction(sculpt: Sculpt) -> None:
    if sculpt.points.shape != sculpt.moves.shape:
        raise ValueError(
            f"sculpt {sculpt.name!r} has {len(sculpt.points)} points and {len(sculpt.moves)} moves; expected as many"
        )
    if sculpt.symmetric:
        middle = (np.abs(sculpt.points[:, 0]) <= _EXACT) & (np.abs(sculpt.moves[:, 0]) > _EXACT)
        if middle.any():
            row = int(middle.argmax())
            raise ValueError(
                f"control point {row} of sculpt {sculpt.name!r} leaves the midline by {sculpt.moves[row, 0]:.4g} m; "
                "expected a symmetric sculpt's midline to stay: move it in y and z only, or say symmetric = false"
            )
    points, _ = _both_sides(sculpt)
    pairs = cKDTree(points).query_pairs(_NEAREST, output_type="ndarray")
    if len(pairs):
        raise ValueError(
            f"two control points of sculpt {sculpt.name!r} lie at {points[pairs[0, 0]]} (mirror images count); "
            f"expected points at least {_NEAREST} m apart: remove one, or put it on the midline"
        )


def _refuse_far(space: ParameterSpace, sculpt: Sculpt) -> None:
    everything = np.concatenate([space.points, *(part.points for part in space.parts.values())])
    distance, _ = cKDTree(everything).query(sculpt.points)
    row = int(distance.argmax())
    if distance[row] > FARTHEST:
        raise ValueError(
            f"control point {row} of sculpt {sculpt.name!r} is {distance[row]:.3g} m from the generic head; expected "
            f"at most {FARTHEST} m: y is up, +z is ahead, and files speak in the unit that they name"
        )
