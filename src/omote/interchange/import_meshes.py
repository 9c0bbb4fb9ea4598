"""Imports expressions from meshes of other programs: heads with morph targets (blendshapes), or one shape each.

The displacement of a head with our topology is converted to a field on S (paper, section 2.2). A keyed model, or a set
of blendshapes, thus becomes expressions that are retargeted to every face of the cast. From which face a shape starts
is found, or checked where it is named, for a wrong one would move every vertex: an expression leaves a part of the head
still, a face is another everywhere. Of 1,921 compounds (17 faces, 113 expressions) a twentieth of the skin moves less
than a micrometre; between two faces of the cast it is .14 mm and more.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from omote.arrays import Points
from omote.builtin import BakedMesh
from omote.interchange.export_face import SKIN, Meshes, compound_meshes, meshes_of
from omote.interchange.formats.glb_reader import Piece
from omote.interchange.mesh_correspondence import MatchedHead, build_face, match_head, refuse_torn, share_order
from omote.model.cast import Cast, Look
from omote.model.extraction.extract import extract
from omote.model.extraction.extracted_expression import describe_uncertainty
from omote.model.known_names import NEUTRAL
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.face_fit import fit
from omote.perform.name_lookup import find_name

Follow = Callable[[int, int, str], None]

STILL = 0.05
QUIET = 0.25
"""Shares of the skin that are compared: what every expression leaves still, and what most of them hardly move."""
ROUNDED = 1e-4
"""Metres by which a program may move what is still."""
NEARER = 4.0
QUIETER = 2.0
"""How many times nearer, in these two shares, another face is that a shape starts from."""
ELSEWHERE = 5e-4
"""Metres; a shape whose still share is farther away starts from no face of the cast."""
RESTS = frozenset({NEUTRAL, "rest", "basis", "base"})
"""Names of a shape at rest."""
SAME = 5e-6
"""Metres; a shape this close to the cast's expression of the same name is taken to be that expression."""
WIDELY = 10.0
"""A head may be so many times larger or smaller than the generic one; beyond that its unit is not metres."""


def find_start(cast: Cast, skin: Points, /) -> str:
    """The face of the cast that a shape's skin (V, 3) starts from, "" for none."""
    nearest = min(cast.faces, key=lambda name: _distances(skin, cast.faces[name]))
    return nearest if _distances(skin, cast.faces[nearest])[0] <= ROUNDED else ""


def check_start(cast: Cast, label: str, skin: Points, start: Face, /, *, named: bool, own_rest: bool = False) -> None:
    """Raises ValueError where the skin (V, 3) of a shape shows that it starts from another face than `start`.

    label: the shape's, for the message; named: a person named the face, else the files did; own_rest: a shape at rest
    lies beside it, so that it may start from any face and move all of it.

    cast: whose faces; start: the face that was said or found.
    """
    still, quiet = _distances(skin, start)
    if still <= ROUNDED:
        return
    others = {name: _distances(skin, face) for name, face in cast.faces.items() if name != start.name}
    nearest = min(others, key=lambda name: others[name], default="")
    far = f"95 % of its skin lies more than {1000 * still:.1f} mm from {start.name!r} at rest"
    if nearest and others[nearest][0] * NEARER < still and others[nearest][1] * QUIETER < quiet:
        mend = f"say --face {nearest}" if named else "take it in alone, or with its own head at rest"
        raise ValueError(f"{label!r} starts from {nearest!r} and not from {start.name!r}: {far}; {mend}")
    if still > ELSEWHERE and not own_rest:
        raise ValueError(
            f"{label!r} does not start from {start.name!r}: {far}, which no expression does, and no face of the cast "
            f"explains it better; add the head that it starts from, at rest, as a shape named {NEUTRAL!r}, and move "
            "and scale the head nowhere before it is exported"
        )


def _distances(skin: Points, face: Face) -> tuple[float, float]:
    """Within which distances, metres, of a face the nearest shares of a skin lie: STILL, QUIET."""
    still, quiet = (int(share * len(skin)) for share in (STILL, QUIET))
    apart = np.partition(np.linalg.norm(skin - face.positions, axis=1), (still, quiet))
    return float(apart[still]), float(apart[quiet])


def ignore_progress(done: int, total: int, what: str, /) -> None:
    """Follows nothing.

    done, total: shapes; what: the next one.
    """


@dataclass(frozen=True, eq=False)
class ImportedExpression:
    """An imported expression; error: metres by which the face wearing it differs from the source shape; doubt: in
    words, how far it may be off on other faces, "" where its face says all of it."""

    label: str
    expression: Expression
    face: str
    error: float
    doubt: str = ""


def import_expressions(
    cast: Cast,
    meshes: Sequence[BakedMesh],
    shapes: Mapping[str, Sequence[Piece]],
    /,
    *,
    face: str = "",
    follow: Follow = ignore_progress,
) -> Iterator[ImportedExpression]:
    """Imports the expressions in shapes, by name: one per morph target; of a shape without any, the shape itself.

    A shape named as a shape at rest (RESTS), or that is a face of the cast, is what the others are measured from; face:
    the face of the cast that they are measured from instead; without either, the face of the cast that a shape shows to
    start from; follow: told of shapes done, of all, and of the next one.
    ValueError where there is no expression, and where a shape starts from another face.

    cast, meshes: the built-in ones; shapes: pieces by the names of files.
    """
    ordered = share_order(cast, meshes, shapes)
    heads = {label: _match_named_head(cast, meshes, label, pieces) for label, pieces in ordered.items()}
    if face:
        face = find_name(face, cast.faces, "face")
    single = {label: head for label, head in heads.items() if not head.moves}
    start = _base_face(cast, single, face)
    own = [rest_label for rest_label, head in single.items() if head.face and head.face == start.name]
    resting = {*own, *(single_label for single_label in single if single_label.lower() in RESTS)}
    total = sum(len(head.moves) for head in heads.values()) + len(single) - len(resting)
    if not total:
        raise ValueError("these files show a face at rest and no expression; add a shape for each expression")
    moved = _moved_shapes(cast, heads, start, resting, face)
    for done, (base, label, moves) in enumerate(moved):
        follow(done, total, label)
        yield _import_expression(cast, base, label, moves)


def _moved_shapes(
    cast: Cast, heads: Mapping[str, MatchedHead], start: Face, resting: Collection[str], face: str
) -> Iterator[tuple[Face, str, Meshes]]:
    """Each shape: the face that it moves, its name, and its displacements."""
    for label, head in heads.items():
        if head.moves and face:
            check_start(cast, label, head.rest[SKIN], start, named=True)
        for name, moves in head.moves.items():
            yield build_face(cast, head, face), name, moves
    rests = any(rest_label.lower() in RESTS for rest_label in resting)
    for label, head in heads.items():
        if not head.moves and label not in resting:
            check_start(cast, label, head.rest[SKIN], start, named=bool(face), own_rest=rests and not face)
            refuse_torn(cast, label, start, head.rest[SKIN])
            before = meshes_of(fit(cast.space, start))
            yield start, label, {name: rest - before[name] for name, rest in head.rest.items()}


def _match_named_head(cast: Cast, meshes: Sequence[BakedMesh], label: str, pieces: Sequence[Piece]) -> MatchedHead:
    try:
        head = match_head(cast, meshes, pieces)
    except ValueError as error:
        raise ValueError(f"{label}: {error}") from error
    size, usual = (float(np.ptp(points, axis=0).max()) for points in (head.rest[SKIN], cast.space.points))
    if not usual / WIDELY <= size <= usual * WIDELY:
        raise ValueError(
            f"{label}: the head is {size:.3g} m long; expected {usual / WIDELY:.2g} to {usual * WIDELY:.2g} m: "
            "export it in metres"
        )
    return head


def _base_face(cast: Cast, heads: Mapping[str, MatchedHead], face: str) -> Face:
    """What shapes without targets are measured from."""
    if face or not heads:
        return cast.faces[face or next(iter(cast.faces))]
    for label, head in heads.items():
        if label.lower() in RESTS:
            return build_face(cast, head)
    for head in heads.values():
        if head.face:
            return cast.faces[head.face]
    for head in heads.values():
        if face_name := find_start(cast, head.rest[SKIN]):
            return cast.faces[face_name]
    raise ValueError(
        f"nothing says from which face {next(iter(heads))!r} starts; add a shape named {NEUTRAL!r}, or name a face of "
        "the cast with --face"
    )


def _import_expression(cast: Cast, face: Face, label: str, moves: Meshes) -> ImportedExpression:
    """Converts displacements of a face to an expression, or finds the cast's expression of this name if it is equal."""
    moves = {SKIN: np.zeros((cast.space.vertex_count, 3)), **moves}
    own = cast.expressions.get(label)
    if own is not None and (off := _position_error(cast, face, own, moves)) <= SAME:
        return ImportedExpression(label, own, face.name, off)
    try:
        parts = {name: moved for name, moved in moves.items() if name != SKIN}
        expression = extract(cast.space, face, moves[SKIN], parts=parts, known=[*cast.expressions.values()])
    except ValueError as error:
        raise ValueError(f"{label!r} does not fit the faces of the cast: {error}") from error
    off = _position_error(cast, face, expression, moves)
    doubt = describe_uncertainty(cast.space, expression)
    return ImportedExpression(label, expression, face.name, off, doubt)


def _position_error(cast: Cast, face: Face, expression: Expression, moves: Meshes) -> float:
    """The largest distance, metres, between a face wearing an expression and the given displacements."""
    worn = compound_meshes(cast.space, face, expression)
    before = meshes_of(fit(cast.space, face))
    return max(float(np.abs(worn[name] - before[name] - moved).max()) for name, moved in moves.items())


def import_face(
    cast: Cast, meshes: Sequence[BakedMesh], label: str, pieces: Sequence[Piece], /
) -> tuple[Face, Look]:  # fmt: skip
    """Imports the face at rest in a file's pieces, with the look of the matching face of the cast, or a plain one.

    ValueError where there is none, or expressions do not fit it.

    cast, meshes: the built-in ones; label: the face's name; pieces: of the file.
    """
    head = _match_named_head(cast, meshes, label, pieces)
    face = Face(label, head.rest[SKIN], {name: points for name, points in head.rest.items() if name != SKIN})
    fit(cast.space, face)
    return face, cast.looks.get(head.face, Look())
