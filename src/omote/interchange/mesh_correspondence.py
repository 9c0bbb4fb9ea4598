"""Finds the correspondence between the vertices of a file's meshes and those of the cast, and the face meant."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from omote.arrays import Points
from omote.builtin import BakedMesh
from omote.interchange.export_face import SKIN, Meshes
from omote.interchange.formats.glb_reader import Piece
from omote.model.cast import Cast
from omote.model.space.face import Face

NEAR = 2e-4
"""Tolerance, metres, in matching a face of the cast: programs round."""
EXACT = 2e-6
"""Metres within which a vertex lies where another one does, however numbers were rounded."""
CHANCES = 4
"""Vertices that an expression may bring there by chance."""
TORN = 3.0
"""How many edges a vertex goes otherwise than each of its neighbours: of 452 expressions of four faces 2.22 at most; of
15 shapes with 5 to 60 vertices in another order 3.25 at least."""
_NUMBERED = re.compile(r"\.\d{3}$")  # what Blender adds to a name that is there already


@dataclass(frozen=True, eq=False)
class MatchedHead:
    """A head with our topology: rest by mesh (n, 3) metres, morph targets by name and mesh; face: the match at rest."""

    face: str
    rest: Meshes
    moves: dict[str, Meshes]


def sizes(cast: Cast) -> dict[str, int]:
    """How many vertices each mesh has: the skin, then the parts."""
    return {SKIN: cast.space.vertex_count} | {name: len(part.points) for name, part in cast.space.parts.items()}


def match_head(cast: Cast, meshes: Sequence[BakedMesh], pieces: Iterable[Piece], /) -> MatchedHead:
    """Matches a file's pieces to the cast's meshes; face: "" where their rest is no face of the cast.

    Vertices are matched by the attribute _VID, else by their order, else by position on a face of the cast.
    ValueError where no piece is a head with our topology.
    """
    gathered: dict[str, tuple[Points, dict[str, Points]]] = {}
    for piece in pieces:
        name, rows = _match_piece(cast, meshes, piece)
        if name:
            _gather(cast, gathered, name, rows, piece)
    if SKIN not in gathered or np.isnan(gathered[SKIN][0]).any():
        raise ValueError(
            f"no head of this topology is in this file: expected a mesh with the {cast.space.vertex_count} vertices of "
            "the cast's skin, in their order or with the attribute _VID; export one from Omote and shape that. Any "
            "other head becomes a face by omote face, or dropped on the editor"
        )
    whole = {name: (rest, moves) for name, (rest, moves) in gathered.items() if not np.isnan(rest).any()}
    rest = {name: points for name, (points, _) in whole.items()}
    labels = dict.fromkeys(label for _, moves in whole.values() for label in moves)
    moves = {label: {name: moved[label] for name, (_, moved) in whole.items() if label in moved} for label in labels}
    return MatchedHead(nearest_face(cast, rest[SKIN]), rest, moves)


def share_order(
    cast: Cast, meshes: Sequence[BakedMesh], shapes: Mapping[str, Sequence[Piece]], /
) -> dict[str, list[Piece]]:
    """Shapes of one head, by names, whose vertices come in one order: where a face of the cast tells that of one, the
    others of as many vertices are told it too, unless they lie nearer to that face in ours.

    cast, meshes: the built-in ones; shapes: pieces by the names of files.
    """
    orders = [mesh.source.astype(np.int64) for mesh in meshes if mesh.name == SKIN]
    ours = {len(order): order for order in (*orders, np.arange(cast.space.vertex_count))}
    told: dict[int, tuple[Points, NDArray[np.int64]]] = {}
    for piece in (piece for pieces in shapes.values() for piece in pieces if piece.rows is None):
        rows = _match_by_place(cast, piece.points) if len(piece.points) in ours else None
        if rows is not None:
            told.setdefault(len(rows), (piece.points, rows))

    def tell(piece: Piece) -> Piece:
        count = len(piece.points)
        if piece.rows is not None or count not in told or piece.moves:
            return piece
        rest, rows = told[count]
        places = np.full((cast.space.vertex_count, 3), np.nan)
        _fill(places, rows, rest, cast.space.welded)
        apart = [float(np.abs(places[order] - piece.points).mean()) for order in (rows, ours[count])]
        return replace(piece, name=SKIN, rows=rows) if apart[0] < apart[1] else piece

    return {label: [tell(piece) for piece in pieces] for label, pieces in shapes.items()}


def refuse_torn(cast: Cast, label: str, face: Face, skin: Points, /) -> None:
    """Raises ValueError where vertices of a shape's skin (V, 3) went another way than every neighbour of theirs, by
    TORN times the edge to it: they come in another order than ours, for no expression does that.

    cast: whose skin; label: the shape's, for the message; face: what it starts from.
    """
    corners = cast.space.triangles
    edges = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    length, apart = (
        np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
        for points in (face.positions.astype(np.float64), skin - face.positions)
    )
    least = np.full(len(skin), np.inf)
    for end in edges.T:
        np.minimum.at(least, end, apart / np.maximum(length, EXACT))
    torn = np.flatnonzero(np.isfinite(least) & (least > TORN))
    if len(torn):
        raise ValueError(
            f"{label!r}: vertex {torn[0]}{f' and {len(torn) - 1} more' if len(torn) > 1 else ''} went another way than "
            "all vertices around: another program changed their order, or tore them out; keep the order or the "
            "attribute _VID where it is shaped, or bring the head at rest and its shapes as one .glb"
        )


def nearest_face(cast: Cast, skin: Points) -> str:
    """The face of the cast whose skin (V, 3) this is, "" for none."""
    off = {name: float(np.abs(face.positions - skin).max()) for name, face in cast.faces.items()}
    best = min(off, key=off.__getitem__)
    return best if off[best] <= NEAR else ""


def _match_piece(cast: Cast, meshes: Sequence[BakedMesh], piece: Piece) -> tuple[str, NDArray[np.int64]]:
    """The mesh that a piece belongs to, and the row of each of its vertices; "" where it belongs to none."""
    named = _NUMBERED.sub("", piece.name)
    counts = sizes(cast)
    none = np.zeros(0, np.int64)
    if piece.rows is not None:
        name = named if named in counts else SKIN
        return (name, piece.rows) if piece.rows.max() < counts[name] else ("", none)
    orders = [(mesh.name, mesh.source.astype(np.int64)) for mesh in meshes]
    orders += [(name, np.arange(count)) for name, count in counts.items()]
    for name, order in orders:
        if len(piece.points) == len(order) and name in (named, SKIN):
            return name, _checked_order(cast, order, piece.points) if name == SKIN else order
    rows = _match_by_place(cast, piece.points)
    return ("", none) if rows is None else (SKIN, rows)


def _checked_order(cast: Cast, order: NDArray[np.int64], points: Points) -> NDArray[np.int64]:
    """The rows of the skin at points (n, 3) that come in our number: in our order where places do not say otherwise,
    else where they lie; ValueError where places say that some are in another order and not in which."""
    if any(np.abs(face.positions[order] - points).max() <= NEAR for face in cast.faces.values()):
        return order
    rows = _match_by_place(cast, points)
    if rows is not None:
        return rows
    for face in cast.faces.values():
        far, at = cKDTree(face.positions).query(points, distance_upper_bound=EXACT)
        elsewhere = np.isfinite(far) & (np.abs(face.positions[order] - points).max(axis=1) > NEAR)
        if elsewhere.sum() > CHANCES:
            first = int(elsewhere.argmax())
            raise ValueError(
                f"{int(elsewhere.sum())} of its vertices are in another order than ours: vertex {first} lies where "
                f"vertex {at[first]} of {face.name!r} does; keep the order or the attribute _VID where it is shaped"
            )
    return order


def _match_by_place(cast: Cast, points: Points) -> NDArray[np.int64] | None:
    """The rows of the skin at points (n, 3), in any order, where they all lie on vertices of one face."""
    if not cast.space.vertex_count * 0.9 <= len(points) <= cast.space.vertex_count * 2:
        return None
    for face in cast.faces.values():
        far, rows = cKDTree(face.positions).query(points, distance_upper_bound=NEAR)
        if np.isfinite(far).all():
            return np.asarray(rows, np.int64)
    return None


def _gather(
    cast: Cast, gathered: dict[str, tuple[Points, dict[str, Points]]], name: str, rows: NDArray[np.int64], piece: Piece
) -> None:  # fmt: skip
    """Adds a piece's vertices to its mesh; doubled vertices of the skin share one position. What is drawn alone has no
    row (below 0)."""
    ours = np.flatnonzero(rows >= 0)
    rows = rows[ours]
    count = sizes(cast)[name]
    rest, moves = gathered.setdefault(name, (np.full((count, 3), np.nan), {}))
    twins = cast.space.welded if name == SKIN else np.arange(count)
    _fill(rest, rows, piece.points[ours], twins)
    for label, moved in piece.moves.items():
        _fill(moves.setdefault(label, np.full((count, 3), np.nan)), rows, moved[ours], twins)
        np.copyto(moves[label], 0.0, where=np.isnan(moves[label]) & ~np.isnan(rest))


def _fill(values: Points, rows: NDArray[np.int64], points: Points, twins: NDArray[np.integer]) -> None:
    values[rows] = points
    lost = np.isnan(values).any(axis=1)
    by_twin = np.full_like(values, np.nan)
    by_twin[twins[rows]] = points
    values[lost] = by_twin[twins[lost]]


def build_face(cast: Cast, like: MatchedHead, name: str = "") -> Face:
    """Builds the face of a matched head: one of the cast (by name, or matched), else the file's own.

    cast: whose faces; like: the matched head; name: of a face of the cast, "" for what matched.
    """
    if chosen := name or like.face:
        return cast.faces[chosen]
    parts = {part: points for part, points in like.rest.items() if part != SKIN}
    return Face("imported", like.rest[SKIN], parts)
