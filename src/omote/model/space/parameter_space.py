"""The parameter space S: the generic face unrolled onto a cylinder (docs/method.md, "The cylinder";
paper, section 2.1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from omote.arrays import Floats, Indices, Mask, Values
from omote.geometry import mesh
from omote.geometry.cylinder import Cylinder
from omote.geometry.laplacian import harmonic_weights, smoothing_matrix
from omote.geometry.locate import Landing, Strip
from omote.model.space import skin_sheet
from omote.model.space.lid_lip_lines import Kind, Line, find_line
from omote.model.space.parts import Part

Radius = Literal["origin", "surface"]
RADIUS_RULES: tuple[Radius, ...] = ("origin", "surface")
Transfer = Literal["smooth", "paper"]
TRANSFERS: tuple[Transfer, ...] = ("smooth", "paper")

# More anchors than this along the sheet's boundary add nothing to the inner skin and make large heads slow to set up.
_MOST_ANCHORS = 400


@dataclass(frozen=True, slots=True, eq=False)
class InnerSkin:
    """The vertices that are not on the sheet and how they follow it: vertices (n,), anchors (n, k) on the sheet,
    weights (n, k)."""

    vertices: Indices
    anchors: Indices
    weights: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Fans:
    """The location triangles around each vertex: those of vertex v are triangles[starts[v]:starts[v + 1]]."""

    starts: Indices
    triangles: Indices


@dataclass(frozen=True, eq=False)
class ParameterSpace:
    """The generic face, its cylinder and the one-layered sheet on which expressions live; made by `build`.

    Attributes
    ----------
    points : ndarray, (V, 3)
        The generic face M0, metres.
    triangles, skin_triangles, membranes : ndarray of int32, (F, 3)
        All triangles; those of the sheet; those over its holes, for location only.
    cylinder : Cylinder
        Around which the head is unrolled.
    radius : {"origin", "surface"}
        Which rule gives a moved point its radius.
    theta, h : ndarray, (V,)
        Where each vertex lies on S, radians and metres.
    strip, fans : Strip, Fans
        What points are located with.
    inner : InnerSkin
        The vertices that are not on the sheet, and how they follow it.
    on_sheet : ndarray of bool, (V,)
        Which vertices are.
    parts : mapping of Part, by name
        Eyeballs, teeth, tongue, lashes.
    transfer : {"smooth", "paper"}
        Which map carries expressions to other faces.
    lines : tuple of Line
        Where lids and lips meet.

    Examples
    --------
    >>> cast.space.points.shape, cast.space.rules
    ((4278, 3), ('origin', 'smooth'))

    References
    ----------
    K. Arai (1993), section 2.1; docs/method.md, "The parameter space".
    """

    points: Values
    triangles: Indices
    skin_triangles: Indices
    membranes: Indices
    cylinder: Cylinder
    radius: Radius
    theta: Values
    h: Values
    strip: Strip
    fans: Fans
    inner: InnerSkin
    on_sheet: Mask
    parts: Mapping[str, Part] = field(default_factory=lambda: MappingProxyType({}))
    transfer: Transfer = "smooth"
    lines: tuple[Line, ...] = ()

    def __post_init__(self) -> None:
        for name in ("points", "triangles", "skin_triangles", "membranes", "theta", "h", "on_sheet"):
            object.__setattr__(self, name, mesh.freeze(getattr(self, name).view()))

    @staticmethod
    def build(
        points: ArrayLike, triangles: ArrayLike, radius: Radius = "origin", *,
        axis: tuple[float, float] | None = None, transfer: Transfer = "smooth", sheet: Indices | None = None,
    ) -> ParameterSpace:  # fmt: skip
        """The parameter space of any head, y up, +z forward: axis, skin sheet and membranes are found here.

        Parameters
        ----------
        points : array_like, (V, 3)
            Metres.
        triangles : array_like, (F, 3)
            Counter-clockwise from outside.
        radius : {"origin", "surface"}
            The rule for a moved point's radius.
        axis : tuple of float, optional
            x and z of the cylinder, metres, where it is known.
        transfer : {"smooth", "paper"}
            The map that carries expressions to other faces.
        sheet : ndarray of int32, (F, 3), optional
            The triangles of the skin sheet where they are known; without it they are found.

        Returns
        -------
        ParameterSpace
            Without parts and lines; `with_parts` and `with_line` add them.

        Raises
        ------
        ValueError
            On arrays that are no mesh, triangles without area, an axis outside the head, and where no sheet is found.

        Examples
        --------
        >>> space = omote.ParameterSpace.build(cast.faces["old"].positions, cast.space.triangles)
        >>> space.vertex_count
        4278

        References
        ----------
        docs/method.md, "The parameter space".
        """
        _refuse_unknown(radius, RADIUS_RULES, "radius")
        _refuse_unknown(transfer, TRANSFERS, "transfer")
        checked = mesh.validate_points(points)
        faces = mesh.validate_triangles(triangles, len(checked))
        skin_sheet.refuse_degenerate(checked, faces)
        joined = mesh.weld(checked)
        cylinder = _cylinder(skin_sheet.find_axis(checked, faces) if axis is None else axis)
        theta, h, _ = cylinder.unroll(checked)
        if sheet is None:
            sheet = faces[skin_sheet.cut_sheet(checked, joined[faces], theta, h, cylinder)]
        skin = mesh.validate_triangles(sheet, len(checked))
        membranes = skin_sheet.close_holes(checked, joined[skin], theta, h, cylinder)
        corners = np.concatenate([joined[skin], membranes])
        skin_sheet.refuse_axis_outside(checked, corners, cylinder)
        strip = Strip.of(skin_sheet.unwrap_corners(theta, corners), h[corners], mesh.neighbours(corners))
        on_sheet = np.isin(joined, corners)
        return ParameterSpace(
            points=checked, triangles=faces, skin_triangles=skin, membranes=membranes, cylinder=cylinder,
            radius=radius, transfer=transfer, theta=theta, h=h, strip=strip, fans=_fans(corners, joined),
            inner=_inner_skin(checked, faces, on_sheet), on_sheet=on_sheet,
        )  # fmt: skip

    @property
    def rules(self) -> tuple[Radius, Transfer]:
        """The rules under which fields on this space are taken and applied."""
        return self.radius, self.transfer

    @property
    def vertex_count(self) -> int:
        """Vertices of the skin, V."""
        return len(self.points)

    @cached_property
    def eyes(self) -> Mapping[str, Part]:
        """The eyeballs among the parts, by name."""
        return MappingProxyType({name: part for name, part in self.parts.items() if part.eye})

    @cached_property
    def welded(self) -> Indices:
        """For each vertex, the first one at its place (V,): texture seams double vertices."""
        return mesh.freeze(mesh.weld(self.points))

    @cached_property
    def sheet_triangles(self) -> Indices:
        """The sheet (F, 3), seams welded."""
        return mesh.freeze(self.welded[self.skin_triangles])

    @cached_property
    def location_triangles(self) -> Indices:
        """Sheet and membranes (L, 3), seams welded: what points are located in."""
        return mesh.freeze(np.concatenate([self.sheet_triangles, self.membranes]))

    def with_parts(self, *parts: Part) -> ParameterSpace:
        """This space with these parts bound to it.

        Parameters
        ----------
        *parts : Part
            Each with its own name; one of a name that is there replaces it.

        Returns
        -------
        ParameterSpace
            All else is shared.

        Examples
        --------
        >>> space = omote.ParameterSpace.build(cast.space.points, cast.space.triangles)
        >>> [*space.with_parts(cast.space.parts["tongue"]).parts]
        ['tongue']
        """
        return replace(self, parts=MappingProxyType({**self.parts, **{part.name: part for part in parts}}))

    def with_line(self, name: str, kind: Kind, near: ArrayLike, /) -> ParameterSpace:
        """This space with a line of lids or lips named: the one around the opening nearest to a point.

        Parameters
        ----------
        name : str
            The line's; one of that name that is there is replaced.
        kind : {"lids", "lips"}
            What meets there.
        near : array_like, (3,)
            A point, metres.

        Returns
        -------
        ParameterSpace
            All else is shared.

        Raises
        ------
        ValueError
            On a point that is none, and where there is no such opening.

        Examples
        --------
        >>> space = omote.ParameterSpace.build(cast.space.points, cast.space.triangles)
        >>> lips = cast.space.points[cast.space.lines[-1].loop].mean(axis=0)
        >>> [line.name for line in space.with_line("lips", "lips", lips).lines]
        ['lips']
        """
        (goal,) = mesh.validate_points(np.reshape(near, (1, -1)), name="near")
        line = find_line(name, kind, self.points, self.sheet_triangles, self.membranes, self.cylinder, goal)
        return replace(self, lines=(*(known for known in self.lines if known.name != name), line))

    def under(self, transfer: Transfer, /) -> ParameterSpace:
        """This space with another transfer rule; expressions are taken anew in it.

        Parameters
        ----------
        transfer : {"smooth", "paper"}
            The rule.

        Returns
        -------
        ParameterSpace
            All else is shared.

        Raises
        ------
        ValueError
            Where there is no such rule.

        Examples
        --------
        >>> cast.space.under("paper").transfer
        'paper'
        """
        _refuse_unknown(transfer, TRANSFERS, "transfer")
        return replace(self, transfer=transfer)

    def locate(self, theta: Values, h: Values, vertices: Indices, /) -> Landing:
        """The triangles of S that hold some points, walking from vertices near them (a visibility walk).

        Parameters
        ----------
        theta, h : ndarray, (N,)
            The points, radians and metres.
        vertices : ndarray of int32, (N,)
            A vertex on the sheet near each.

        Returns
        -------
        Landing
            For each point the row in `location_triangles` and its barycentric weights (N, 3).

        Examples
        --------
        >>> rows = np.flatnonzero(cast.space.on_sheet)[:3]
        >>> landing = cast.space.locate(cast.space.theta[rows], cast.space.h[rows], rows)
        >>> bool(np.allclose(landing.weights.max(axis=1), 1))  # each is a corner of its triangle
        True
        """
        return self.strip.locate(theta, h, self.fans.triangles[self.fans.starts[vertices]])


def refuse_no_space(space: object, /) -> None:
    """Raises TypeError where a space was expected and something else came."""
    if not isinstance(space, ParameterSpace):
        raise TypeError(f"the space is a {type(space).__name__}; expected an omote.ParameterSpace, such as cast.space")


def _refuse_unknown(value: object, rules: tuple[str, ...], name: str) -> None:
    if not isinstance(value, str) or value not in rules:
        raise ValueError(f"{name} is {value!r}; expected one of {', '.join(map(repr, rules))}")


def _cylinder(axis: ArrayLike) -> Cylinder:
    place = mesh.validate_numbers(axis, name="axis")
    if place.shape != (2,):
        raise ValueError(f"axis has shape {place.shape}; expected two numbers, x and z in metres")
    if len(mesh.rows_out_of_reach(place)):
        raise ValueError(f"axis is {place}; expected finite metres, x and z, at most {mesh.FARTHEST:g} from zero")
    return Cylinder(float(place[0]), float(place[1]))


def _fans(corners: Indices, joined: Indices) -> Fans:
    owner = corners.ravel()
    triangle = np.repeat(np.arange(len(corners), dtype=np.int32), 3)
    order = np.argsort(owner, kind="stable")
    counts = np.bincount(owner, minlength=len(joined))
    starts = np.concatenate([[0], np.cumsum(counts)])
    if np.array_equal(joined, np.arange(len(joined))):
        return Fans(starts.astype(np.int32), triangle[order])
    # A doubled vertex has the fan of its first copy.
    copies = counts[joined]
    ends = np.concatenate([[0], np.cumsum(copies)]).astype(np.int32)
    rows = np.repeat(starts[joined] - ends[:-1], copies) + np.arange(ends[-1])
    return Fans(ends, triangle[order][rows])


def _inner_skin(points: Values, triangles: Indices, on_sheet: Mask) -> InnerSkin:
    joined = mesh.weld(points)
    corners = joined[triangles]
    free = ~on_sheet
    across = np.unique(corners[free[corners].any(axis=1)])
    anchors = _thin_anchors(points, across[on_sheet[across]].astype(np.int32))
    own = free & (joined == np.arange(len(points)))
    names, weights = harmonic_weights(points, corners, own, anchors)
    vertices = np.flatnonzero(free).astype(np.int32)
    first = np.searchsorted(np.flatnonzero(own), joined[vertices])
    names = names[first]
    weights = weights[first]
    names, weights = skin_sheet.bind_islands(points, vertices, np.flatnonzero(on_sheet), names, weights)
    return InnerSkin(vertices, np.ascontiguousarray(names, np.int32), np.ascontiguousarray(weights, np.float32))


def _thin_anchors(points: Values, anchors: Indices) -> Indices:
    """At most _MOST_ANCHORS of the anchors, far from each other."""
    if len(anchors) <= _MOST_ANCHORS:
        return anchors
    distance = np.full(len(anchors), np.inf)
    chosen = np.empty(_MOST_ANCHORS, dtype=np.int64)
    here = 0
    for i in range(_MOST_ANCHORS):
        chosen[i] = here
        distance = np.minimum(distance, ((points[anchors] - points[anchors[here]]) ** 2).sum(axis=1))
        here = int(distance.argmax())
    return np.sort(anchors[chosen])


def smoothed_scale(space: ParameterSpace, positions: Values, /, *, rounds: int = 30) -> Values:
    """How much larger a face is than the generic one at each vertex: (V,), smoothed over `rounds` rings.

    space: the space of the generic head; positions: (V, 3), metres.

    docs/method.md, "Detail transfer".
    """
    average = smoothing_matrix(space.triangles, space.vertex_count)
    here = np.zeros(space.vertex_count)
    there = np.zeros(space.vertex_count)
    for corner in range(3):
        np.add.at(here, space.triangles[:, corner], mesh.areas(positions, space.triangles))
        np.add.at(there, space.triangles[:, corner], mesh.areas(space.points, space.triangles))
    for _ in range(rounds):
        here = average @ here
        there = average @ there
    return np.sqrt(np.divide(here, there, out=np.ones_like(here), where=there > 0))
