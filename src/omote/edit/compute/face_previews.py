"""What an editor looks at before a face is taken: a scan thinned beside the face fitted to it, or a skin as photographs
show it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from msgspec import structs
from numpy.typing import ArrayLike, NDArray

from omote.arrays import Values
from omote.builtin import load_meshes
from omote.edit.protocol.messages import PhotographPreview, ScanDoubt, ScanFigures, ScanPreview
from omote.interchange.scan_face import PhotographFace, ScanFace
from omote.interchange.scans.scan_reader import ScanFile
from omote.interchange.skin_texture import load_canvas, paint_skin
from omote.model.cast import Cast
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.head_zones import head_zones
from omote.model.fitting.scan import Scan
from omote.model.space.similarity import Similarity
from omote.show.wire import le_bytes
from omote.stage_data.assets import rest_positions

Point = tuple[float, float, float]

AROUND = 0.12
"""Metres around the head that are shown of a scan."""
MOST_TRIANGLES = 60_000
MOST_POINTS = 60_000
"""Of a thinned scan."""
FINER = 2
"""Times that each edge of a skin is halved: its vertices are further apart than what one knows a person by."""
_COARSER = 1.15
"""Times that a cell of the grid grows until few enough points are left."""
_TRIANGLES_A_CELL = 2.0
"""About so many triangles cross a cell of the grid."""


def show_scan(cast: Cast, read: ScanFile, scan_face: ScanFace, points: Mapping[str, Point], /) -> ScanPreview:
    """The preview of a scan, still without token, file and what was said of its eyes.

    It is thinned, where its face was fitted; without one it is shown whole, as large as a head and as upright as it is.

    cast: the built-in one; read: the scan; scan_face: what came of it; points: what people clicked, in its frame.
    """
    preview = ScanPreview(
        token="", file="", placement=[], unit="", positions=b"", triangles=b"", colours=b"", found={},
        doubts=[ScanDoubt(doubt.kind, str(doubt)) for doubt in scan_face.doubts], notes=[*read.notes, *scan_face.notes],
        given={name: list(point) for name, point in points.items()},
    )  # fmt: skip
    if scan_face.fit is None or scan_face.look is None or scan_face.place is None:
        whole = _place_whole(cast, read.scan)
        return _add_scan(preview, thin_scan(read.scan, whole), whole, "an unknown unit", points)
    corners = np.stack([cast.space.points.min(axis=0) - AROUND, cast.space.points.max(axis=0) + AROUND])
    placement = scan_face.fit.placement
    around = None if scan_face.place.doubts else corners  # what is not sure may be elsewhere
    thin = thin_scan(read.scan, placement, around)
    return structs.replace(
        _add_scan(preview, thin, placement, scan_face.place.unit, scan_face.place.landmarks),
        face=le_bytes(rest_positions(cast, scan_face.fit.face), "<f4"),
        residual=le_bytes(scan_face.fit.residual, "<f4"),
        figures=figures_of(cast, scan_face.fit),
        hair_style=scan_face.look.hair_style,
        hair=scan_face.look.hair,
    )


def _add_scan(
    preview: ScanPreview, thin: ThinScan, placement: Similarity, unit: str, landmarks: Mapping[str, ArrayLike]
) -> ScanPreview:
    return structs.replace(
        preview,
        placement=[float(placement.scale), *placement.rotation.reshape(-1).tolist(), *placement.shift.tolist()],
        unit=f"{unit}, {_describe_axis(placement.rotation[1])} up, facing {_describe_axis(placement.rotation[2])}",
        found={name: np.asarray(point).tolist() for name, point in landmarks.items()},
        positions=le_bytes(thin.positions, "<f4"),
        triangles=le_bytes(thin.triangles, "<u4"),
        colours=b"" if thin.colours is None else le_bytes(thin.colours, "u1"),
    )


def _describe_axis(axis: Values) -> str:
    """The axis of a scan nearest to a direction in its frame."""
    at = int(np.abs(axis).argmax())
    return f"{'-' if axis[at] < 0.0 else ''}{'xyz'[at]}"


def _place_whole(cast: Cast, scan: Scan) -> Similarity:
    """The whole scan as large as a head, as upright as it is."""
    middle = (scan.positions.min(axis=0) + scan.positions.max(axis=0)) / 2
    size = float(np.ptp(cast.space.points[:, 1])) / max(float(np.ptp(scan.positions, axis=0).max()), 1e-9)
    return Similarity(size, np.eye(3), cast.space.points.mean(axis=0) - size * middle)


def figures_of(cast: Cast, fitted: Fit, /) -> ScanFigures:
    """How far a fitted face is from what the scan shows of it.

    cast: the built-in one; fitted: the fit.
    """
    face = fitted.residual[head_zones(cast.space).face]
    seen = face[np.isfinite(face)]
    if not seen.size:
        return ScanFigures(0.0, 0.0, 0.0)
    return ScanFigures(float(np.median(seen)), float(np.percentile(seen, 95)), len(seen) / len(face))


def show_photographs(cast: Cast, photograph_face: PhotographFace, /) -> PhotographPreview:
    """The preview of a face made of photographs, still without its token.

    cast: the built-in one; photograph_face: what came of the photographs.
    """
    skin = load_meshes()[0]
    face = photograph_face.fit.face
    drawn = colour_skin(
        face.positions[skin.source], skin.uv, skin.triangles, paint_skin(load_canvas(cast.space), photograph_face.look)
    )
    seen = np.zeros(cast.space.vertex_count, np.uint8)
    np.maximum.at(seen, skin.source, texels_at(skin.uv, photograph_face.seen))
    return PhotographPreview(
        token="",
        doubts=list(photograph_face.fit.doubts),
        off=list(photograph_face.fit.residual),
        spread=photograph_face.fit.spread,
        seen=float((seen[np.unique(cast.space.skin_triangles)] > 0).mean()),
        positions=le_bytes(drawn.positions, "<f4"),
        triangles=le_bytes(drawn.triangles, "<u4"),
        colours=le_bytes(drawn.colours, "u1"),
        face=le_bytes(rest_positions(cast, face), "<f4"),
        shown=le_bytes(seen, "u1"),
        hair_style=photograph_face.look.hair_style,
        hair=photograph_face.look.hair,
    )


@dataclass(frozen=True, eq=False)
class ThinScan:
    """positions (n, 3) float32; triangles (t, 3) uint32, none of a cloud; colours (n, 3) uint8 sRGB, or None."""

    positions: NDArray[np.float32]
    triangles: NDArray[np.uint32]
    colours: NDArray[np.uint8] | None


def thin_scan(scan: Scan, placement: Similarity, around: Values | None = None, /) -> ThinScan:
    """The scan where it was placed, its points merged by the cells of a grid (Rossignac and Borrel 1993) until at most
    MOST_TRIANGLES triangles and MOST_POINTS points are left.

    around: the least and the greatest corner (2, 3), metres, of what is kept of it; None keeps all.

    scan: in its own frame; placement: from there to the face's metres.
    """
    points = placement(scan.positions)
    colours = _colours_of_points(scan)
    triangles = np.zeros((0, 3), np.int32) if scan.triangles is None else scan.triangles
    if around is not None:
        points, triangles, colours = _cut(points, triangles, colours, around)
    if not _is_thin(points, triangles):
        cell = _first_cell(points, triangles)
        while not _is_thin(*(thinned := _merge(points, triangles, colours, cell))[:2]):
            cell *= _COARSER
        points, triangles, colours = thinned
    shades = None if colours is None else np.rint(colours).astype(np.uint8)
    return ThinScan(points.astype(np.float32), triangles.astype(np.uint32), shades)


def _is_thin(points: Values, triangles: NDArray[np.integer]) -> bool:
    return len(triangles) <= MOST_TRIANGLES and (len(triangles) > 0 or len(points) <= MOST_POINTS)


def _colours_of_points(scan: Scan) -> Values | None:
    """The colour (n, 3) of each point: its own, else its texture's at one of its corners."""
    if scan.texture is None or scan.texcoords is None or scan.triangles is None:
        return None if scan.colours is None else scan.colours.astype(np.float64)
    height, width = scan.texture.shape[:2]
    places = scan.texcoords.reshape(-1, 2) * [width, height]
    columns = np.clip(places[:, 0].astype(np.int64), 0, width - 1)
    rows = np.clip(places[:, 1].astype(np.int64), 0, height - 1)
    colours = np.full((len(scan.positions), 3), 128.0)
    colours[scan.triangles.reshape(-1)] = scan.texture[rows, columns]
    return colours


def _cut(
    points: Values, triangles: NDArray[np.integer], colours: Values | None, around: Values
) -> tuple[Values, NDArray[np.integer], Values | None]:
    inside = ((points >= around[0]) & (points <= around[1])).all(axis=1)
    if not inside.any():
        return points, triangles, colours
    place = np.cumsum(inside) - 1
    kept = triangles[inside[triangles].all(axis=1)] if len(triangles) else triangles
    return points[inside], place[kept], None if colours is None else colours[inside]


def _first_cell(points: Values, triangles: NDArray[np.integer]) -> float:
    """The edge of a grid's cells that leaves about as many as are wanted."""
    if len(triangles):
        a, b, c = points[triangles].transpose(1, 0, 2)
        area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2
        cell = float(np.sqrt(_TRIANGLES_A_CELL * area / MOST_TRIANGLES))
    else:
        cell = float(np.sqrt((np.ptp(points, axis=0) ** 2).sum() / MOST_POINTS)) / 2
    return max(cell, 1e-9 * float(np.abs(points).max(initial=1.0)))


def _merge(
    points: Values, triangles: NDArray[np.integer], colours: Values | None, cell: float
) -> tuple[Values, NDArray[np.integer], Values | None]:
    """Each cell's points as one, in their middle, in their mean colour; triangles that lie in fewer cells than three,
    or where another lies, go."""
    low = points.min(axis=0)
    keys = np.minimum((points - low) / cell, 2**20 - 1).astype(np.int64) @ np.array([1 << 40, 1 << 20, 1])
    _, place, counts = np.unique(keys, return_inverse=True, return_counts=True)
    middles = np.stack([np.bincount(place, axis) for axis in points.T], axis=1) / counts[:, None]
    shades = colours
    if colours is not None:
        shades = np.stack([np.bincount(place, channel) for channel in colours.T], axis=1) / counts[:, None]
    merged = place[triangles].reshape(-1, 3)
    merged = merged[(merged != np.roll(merged, 1, axis=1)).all(axis=1)]
    _, first = np.unique(np.sort(merged, axis=1), axis=0, return_index=True)
    return middles, merged[np.sort(first)], shades


@dataclass(frozen=True, eq=False)
class ColouredSkin:
    """positions (n, 3) float32 metres; triangles (t, 3) uint32; colours (n, 3) uint8 sRGB."""

    positions: NDArray[np.float32]
    triangles: NDArray[np.uint32]
    colours: NDArray[np.uint8]


def colour_skin(
    positions: NDArray[np.floating], uv: NDArray[np.floating], triangles: NDArray[np.integer],
    painted: NDArray[np.uint8], /,
) -> ColouredSkin:  # fmt: skip
    """A finer mesh of positions (k, 3), triangles (t, 3) and texture coordinates (k, 2) from the upper left corner,
    with the colours of a texture (s, s, 3).

    positions, triangles, uv: the skin; painted (s, s, 3): its texture, sRGB.
    """
    corners = np.concatenate([positions, uv], axis=1).astype(np.float64)
    for _ in range(FINER):
        corners, triangles = halve_edges(corners, triangles)
    colours = texels_at(corners[:, 3:], painted)
    return ColouredSkin(corners[:, :3].astype(np.float32), triangles.astype(np.uint32), colours)


def texels_at(uv: NDArray[np.floating], texture: NDArray[np.uint8], /) -> NDArray[np.uint8]:
    """The texels of a texture (s, s, ...) in which texture coordinates (n, 2) lie.

    uv (n, 2): 0 to 1, from the upper left corner; texture (s, s, ...): any.
    """
    side = len(texture)
    columns, rows = np.clip((uv * side).astype(np.int64), 0, side - 1).T
    texels: NDArray[np.uint8] = texture[rows, columns]
    return texels


def halve_edges(corners: Values, triangles: NDArray[np.integer], /) -> tuple[Values, NDArray[np.integer]]:
    """Each triangle (t, 3) as four: vertices (n, c) with those in the middles of the edges after them.

    corners (n, c): numbers of each vertex; triangles (t, 3): rows of them.
    """
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    once, which = np.unique(edges, axis=0, return_inverse=True)
    ab, bc, ca = (len(corners) + which.reshape(-1, 3)).T
    a, b, c = triangles.T
    four = np.concatenate(
        [np.stack(triangle, axis=1) for triangle in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))]
    )
    return np.concatenate([corners, corners[once].mean(axis=1)]), four
