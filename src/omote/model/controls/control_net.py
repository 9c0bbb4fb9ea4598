"""The control net: how artists write expressions (paper, section 2.3; docs/method.md, "The control net")."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike
from scipy import sparse
from scipy.spatial import Delaunay

from omote.arrays import Indices, Values
from omote.geometry import mesh
from omote.geometry.cylinder import wrap
from omote.geometry.locate import Strip
from omote.model.controls.upper_lower import clamp_weights, is_across, nearest_own_side, sides
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.paper_map import project_to_surface

# Points of each still ring that closes the net at neck and crown.
_RING = 16
# So far aside the net leans where it is triangulated, of its height.
_LEAN = 1e-5


@dataclass(frozen=True, eq=False)
class ControlNet:
    """Points on S joined by a Delaunay net that is periodic in theta (a control cage); made by `build`.

    No vertex has its weights from across an opening of lids or lips.

    Attributes
    ----------
    space : ParameterSpace
        Where the points are.
    theta, h : ndarray, (n,)
        Radians and metres: the artist's points first, then the two still rings.
    triangles : ndarray of int32, (t, 3)
        The net.
    corners : ndarray of int32, (V, 3)
        The points around each vertex of the skin.
    weights : ndarray, (V, 3)
        Its barycentric weights (eq. 1), all zero off the sheet.
    own : int
        How many points are the artist's.

    Examples
    --------
    >>> theta, h = np.meshgrid(np.arange(-3, 4) * 0.8, [-0.1, -0.05, 0.0, 0.05, 0.1])
    >>> net = omote.ControlNet.build(cast.space, theta.ravel(), h.ravel())
    >>> net.own, net.basis.shape[0]
    (35, 4278)

    References
    ----------
    K. Arai (1993), section 2.3; docs/method.md, "Writing expressions".
    """

    space: ParameterSpace
    theta: Values
    h: Values
    triangles: Indices
    corners: Indices
    weights: Values
    own: int

    @cached_property
    def basis(self) -> sparse.csr_array:
        """The weights as a matrix (V, n), so that a field is `basis @ values` (eq. 2)."""
        rows = np.repeat(np.arange(len(self.corners)), 3)
        shape = (len(self.corners), len(self.theta))
        return sparse.coo_array((self.weights.ravel(), (rows, self.corners.ravel())), shape=shape).tocsr()

    @staticmethod
    def build(space: ParameterSpace, theta: ArrayLike, h: ArrayLike) -> ControlNet:
        """The net of some points of S, with a still ring at neck and crown.

        Parameters
        ----------
        space : ParameterSpace
            Where the points are.
        theta, h : array_like, (n,)
            Radians and metres; at least three points.

        Returns
        -------
        ControlNet
            With the barycentric weights of every vertex.

        Raises
        ------
        ValueError
            On values that are not finite, fewer than three points, points off the sheet's heights and points at the
            same place.

        Examples
        --------
        >>> rows = np.flatnonzero(cast.space.on_sheet)[::40]
        >>> omote.ControlNet.build(cast.space, cast.space.theta[rows], cast.space.h[rows]).weights.shape
        (4278, 3)
        """
        theta, h = _validate_points(space, theta, h)
        low, high = _heights(space)
        margin = 0.02 * (high - low)
        turns = wrap(2 * np.pi * np.arange(_RING) / _RING)
        # The upper ring is turned by half a step: four points of two rings on one circle would have two Delaunay nets.
        all_theta = np.concatenate([theta, turns, wrap(turns + np.pi / _RING)])
        all_h = np.concatenate([h, np.full(_RING, low - margin), np.full(_RING, high + margin)])
        metric = float(space.cylinder.unroll(space.points[space.on_sheet])[2].mean())
        triangles, unrolled = _periodic_delaunay(all_theta, all_h, metric)
        if len(mesh.boundary_edges(triangles)) != 2 * _RING:
            raise ValueError(
                f"{len(theta)} control points join each other around both sides of the head; "
                "expected enough points, all around, that every edge of the net is the only one between its ends"
            )
        corners, weights = _weights_around(space, all_theta, all_h, triangles, unrolled, metric)
        return ControlNet(space, all_theta, all_h, triangles, corners, weights, len(theta))

    def expression(self, values: ArrayLike, /) -> Expression:
        """Interpolates vectors at the control points to an expression (eq. 2).

        Parameters
        ----------
        values : array_like, (own, 3) or, the rings moving too, (n, 3)
            dtheta (radians), dh (metres) and R at each point.

        Returns
        -------
        Expression
            The barycentric mean at each vertex; nothing moves that no moved point is a corner of.

        Raises
        ------
        ValueError
            On other shapes, values that are not finite and ratios that are not positive.

        Examples
        --------
        >>> rows = np.flatnonzero(cast.space.on_sheet)[::40]
        >>> net = omote.ControlNet.build(cast.space, cast.space.theta[rows], cast.space.h[rows])
        >>> values = np.tile([0.0, 0.0, 1.0], (net.own, 1))
        >>> values[20] = 0.1, 0.002, 1.05
        >>> moved = net.expression(values)
        >>> bool(np.isclose(moved.dtheta.max(), 0.1)), bool(np.isclose(moved.ratio.max(), 1.05))
        (True, True)
        """
        given = np.asarray(values, dtype=np.float64)
        if given.ndim != 2 or given.shape not in ((self.own, 3), (len(self.theta), 3)):
            raise ValueError(
                f"values has shape {given.shape}; expected ({self.own}, 3), or ({len(self.theta)}, 3) with the rings"
            )
        bad = np.flatnonzero(~np.isfinite(given).all(axis=1) | (given[:, 2] <= 0))
        if len(bad):
            raise ValueError(f"values[{bad[0]}] is {given[bad[0]]}; expected finite dtheta and dh and a positive R")
        still = np.tile([0.0, 0.0, 1.0], (len(self.theta) - len(given), 1))
        field = np.concatenate([given, still]) - [0.0, 0.0, 1.0]
        dtheta, dh, over = (self.basis @ field).T
        inner = np.zeros((len(self.space.inner.vertices), 3))
        return Expression(dtheta, dh, 1.0 + over, inner, radius=self.space.radius, transfer=self.space.transfer)

    def points_on(self, face: Face, /) -> Values:
        """Where the artist's control points lie on a face: the needles of figure 6.

        Parameters
        ----------
        face : Face
            Any face of the space.

        Returns
        -------
        ndarray, (own, 3)
            Metres.

        Raises
        ------
        ValueError
            Where the face does not belong to the space.

        Examples
        --------
        >>> rows = np.flatnonzero(cast.space.on_sheet)[::40]
        >>> net = omote.ControlNet.build(cast.space, cast.space.theta[rows], cast.space.h[rows])
        >>> needles = net.points_on(cast.faces["dog"])
        >>> bool(np.allclose(needles[0], cast.faces["dog"].positions[rows[0]], atol=1e-6))
        True
        """
        triangles, weights = self._landing()
        return (weights[..., None] * fit(self.space, face).positions[triangles]).sum(axis=1)

    def drag(self, face: Face, point: int, target: ArrayLike, /) -> tuple[float, float]:
        """The vector that carries a control point to where a target lies on a face.

        The target is slid onto the face along its cylinder radius.

        Parameters
        ----------
        face : Face
            The face that is worked on.
        point : int
            The control point, 0 to own - 1.
        target : array_like, (3,)
            Where it is to go, metres.

        Returns
        -------
        tuple of float
            dtheta (radians) and dh (metres).

        Raises
        ------
        ValueError
            On a point that is not in the net and on a target that is not finite.

        Examples
        --------
        >>> rows = np.flatnonzero(cast.space.on_sheet)[::40]
        >>> net = omote.ControlNet.build(cast.space, cast.space.theta[rows], cast.space.h[rows])
        >>> stays = net.drag(cast.faces["dog"], 3, net.points_on(cast.faces["dog"])[3])
        >>> bool(np.allclose(stays, 0, atol=1e-6))
        True
        """
        if not 0 <= point < self.own:
            raise ValueError(f"control point {point} does not exist; expected 0 to {self.own - 1}")
        goal = mesh.validate_points(np.reshape(target, (1, -1)), name="target")
        near = self._landing()[0][point, :1].astype(np.int32)
        landing = project_to_surface(self.space, fit(self.space, face).positions.astype(np.float64), goal, near)
        corners = self.space.location_triangles[landing.triangles[0]]
        first = self.space.theta[corners[0]]
        theta = first + landing.weights[0] @ wrap(self.space.theta[corners] - first)
        dtheta = wrap(np.array(theta - self.theta[point]))
        return float(dtheta), float(landing.weights[0] @ self.space.h[corners] - self.h[point])

    def _landing(self) -> tuple[Indices, Values]:
        theta = self.theta[: self.own]
        h = self.h[: self.own]
        start = _nearest_vertices(self.space, theta, h)
        landing = self.space.locate(theta, h, start)
        return self.space.location_triangles[landing.triangles], landing.weights


def _validate_points(space: ParameterSpace, theta: ArrayLike, h: ArrayLike) -> tuple[Values, Values]:
    angles = np.asarray(theta, dtype=np.float64)
    heights = np.asarray(h, dtype=np.float64)
    if angles.ndim != 1 or angles.shape != heights.shape or len(angles) < 3:
        raise ValueError(
            f"theta {angles.shape} and h {heights.shape} of a control net; expected two arrays (n,) with n >= 3"
        )
    low, high = _heights(space)
    bad = np.flatnonzero(~np.isfinite(angles) | ~np.isfinite(heights) | (heights <= low) | (heights >= high))
    if len(bad):
        raise ValueError(
            f"control point {bad[0]} is at theta = {angles[bad[0]]}, h = {heights[bad[0]]}; expected finite values "
            f"with h between {low:.4g} and {high:.4g}"
        )
    angles = wrap(angles)
    if len(np.unique(np.stack([angles, heights], axis=1).round(9), axis=0)) < len(angles):
        raise ValueError("two control points are at the same place on S; expected each at its own")
    return angles, heights


def _heights(space: ParameterSpace) -> tuple[float, float]:
    h = space.h[space.on_sheet]
    return float(h.min()), float(h.max())


def _periodic_delaunay(theta: Values, h: Values, metric: float) -> tuple[Indices, Values]:
    """The Delaunay triangles of one period, theta scaled to metres, and their unwrapped corner angles (t, 3).

    Three periods are triangulated; a triangle is kept once, where its lowest-numbered corner lies in the middle one.
    """
    count = len(theta)
    shifts = np.repeat([-2 * np.pi, 0.0, 2 * np.pi], count)
    unrolled = np.tile(theta, 3) + shifts
    # Four points of a symmetric net often lie on one circle; leaning a little, every period cuts them the same way.
    leaning = unrolled * metric + _LEAN * np.tile(h, 3)
    simplices = Delaunay(np.stack([leaning, np.tile(h, 3)], axis=1)).simplices
    owner = simplices % count
    lowest = np.take_along_axis(simplices, owner.argmin(axis=1)[:, None], axis=1)[:, 0]
    kept = simplices[(lowest >= count) & (lowest < 2 * count)]
    corners = unrolled[kept]
    height = np.tile(h, 3)[kept]
    doubled = (corners[:, 1] - corners[:, 0]) * (height[:, 2] - height[:, 0]) - (corners[:, 2] - corners[:, 0]) * (
        height[:, 1] - height[:, 0]
    )
    kept[doubled < 0] = kept[doubled < 0][:, ::-1]
    kept = kept[np.abs(doubled) > 1e-12]
    return np.ascontiguousarray(kept % count, np.int32), unrolled[kept]


def _weights_around(
    space: ParameterSpace, theta: Values, h: Values, triangles: Indices, unrolled: Values, metric: float
) -> tuple[Indices, Values]:
    """The points around each vertex (V, 3) and its weights (V, 3), from its own side of lids and lips."""
    strip = Strip.of(unrolled, h[triangles], mesh.neighbours(triangles))
    sheet = np.flatnonzero(space.on_sheet)
    landing = strip.locate(space.theta[sheet], space.h[sheet], np.zeros(len(sheet), np.int32))
    landed = landing.triangles.copy()
    shares = landing.weights.copy()
    of_vertices = sides(space)[:, sheet]
    of_points = sides(space)[:, _nearest_vertices(space, theta, h)]
    across = np.flatnonzero(is_across(of_vertices, of_points[:, triangles[landed]]))
    middle = unrolled.mean(axis=1, keepdims=True)
    plane = np.stack([(unrolled - middle + wrap(middle)) * metric, h[triangles]], axis=2)
    where = np.stack([space.theta[sheet[across]] * metric, space.h[sheet[across]]], axis=1)
    own = nearest_own_side(of_vertices[:, across], of_points, triangles, plane, where)
    across = across[own >= 0]
    where = where[own >= 0]
    own = own[own >= 0]
    landed[across] = own
    shares[across] = clamp_weights(_barycentric(plane[own], where))
    corners = np.zeros((space.vertex_count, 3), np.int32)
    weights = np.zeros((space.vertex_count, 3))
    corners[sheet] = triangles[landed]
    weights[sheet] = shares
    return corners, weights


def _barycentric(corners: Values, where: Values) -> Values:
    """The weights (n, 3) of points (n, 2) in triangles with corners (n, 3, 2), beyond their edges too."""
    sides = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    two = np.linalg.solve(sides, (where - corners[:, 0])[..., None])[..., 0]
    return np.column_stack([1.0 - two.sum(axis=1), two])


def _nearest_vertices(space: ParameterSpace, theta: Values, h: Values) -> Indices:
    sheet = np.flatnonzero(space.on_sheet)
    metric = float(space.cylinder.unroll(space.points[sheet])[2].mean())
    across = wrap(theta[:, None] - space.theta[sheet]) * metric
    return sheet[np.hypot(across, h[:, None] - space.h[sheet]).argmin(axis=1)].astype(np.int32)
