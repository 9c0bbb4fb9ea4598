"""Reads and writes expressions as JSON documents for exchange (docs/exchange.md, docs/expression.schema.json).

`dense` is the whole field, number for number, on the head that `space` names. `control`, where an expression is made of
control points alone, says the same by places on S, for any head.
"""

from __future__ import annotations

import hashlib
from typing import Annotated, Any, Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.file_content import explain_syntax
from omote.model.space.complexion import MOST, PALE, check_complexion
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace

LARGEST = 32 * 2**20
"""Bytes of a document at most."""
MOST_POINTS = 400
MOST_ROWS = 200_000
FARTHEST_TURN = 7.0
FARTHEST_MOVE = 10.0
WIDEST = 100.0
NARROWEST = 1e-3
"""Limits of displacements: radians, metres, ratios of radii."""

Row = Annotated[int, msgspec.Meta(ge=0, lt=MOST_ROWS)]
Rows = Annotated[list[Row], msgspec.Meta(max_length=MOST_ROWS)]
Turn = Annotated[float, msgspec.Meta(ge=-FARTHEST_TURN, le=FARTHEST_TURN)]
Move = Annotated[float, msgspec.Meta(ge=-FARTHEST_MOVE, le=FARTHEST_MOVE)]
Ratio = Annotated[float, msgspec.Meta(ge=NARROWEST, le=WIDEST)]
Blood = Annotated[float, msgspec.Meta(ge=-MOST, le=MOST)]
Turns = Annotated[list[Turn], msgspec.Meta(max_length=MOST_ROWS)]
Moves = Annotated[list[Move], msgspec.Meta(max_length=MOST_ROWS)]
Ratios = Annotated[list[Ratio], msgspec.Meta(max_length=MOST_ROWS)]
Vector = tuple[Move, Move, Move]
Vectors = Annotated[list[Vector], msgspec.Meta(max_length=MOST_ROWS)]
Text = Annotated[str, msgspec.Meta(max_length=200)]


class Control(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Control points at theta (radians) and h (metres), and each one's dtheta (radians), dh (metres) and R."""

    points: Annotated[list[tuple[Turn, Move]], msgspec.Meta(max_length=MOST_POINTS)]
    vectors: Annotated[list[tuple[Turn, Move, Ratio]], msgspec.Meta(max_length=MOST_POINTS)]


class Sheet(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The field where the sheet moves: rows of vertices, and dtheta (radians), dh (metres) and R of each."""

    rows: Rows
    dtheta: Turns
    dh: Moves
    ratio: Ratios


class Rest(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Residual displacements beyond what follows from the skin: rows, and metres on the generic face."""

    rows: Rows
    moves: Vectors


class Dense(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """An expression, number for number; inner: rows of the inner skin; eyes: yaw and pitch, left and right; ears: how
    far the left and the right one go back, up and out; head: yaw, pitch, roll; radians. complexion: blood of cheeks,
    nose, forehead, eyes and the whole face, tears and sweat."""

    sheet: Sheet
    inner: Rest
    parts: Annotated[dict[Text, Rest], msgspec.Meta(max_length=64)]
    eyes: tuple[Turn, Turn, Turn, Turn]
    pupil: Annotated[float, msgspec.Meta(ge=-10.0, le=10.0)]
    radius: Literal["origin", "surface"]
    transfer: Literal["smooth", "paper"]
    ears: tuple[Turn, Turn, Turn, Turn, Turn, Turn] | None = None
    head: tuple[Turn, Turn, Turn] | None = None
    complexion: tuple[Blood, Blood, Blood, Blood, Blood, Blood, Blood] | None = None


class ExpressionFile(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An expression for exchange; space: the digest of the generic head that rows belong to; made_of: for people."""

    omote: Literal["expression"]
    version: Literal[1]
    label: Annotated[str, msgspec.Meta(min_length=1, max_length=80)]
    tags: Annotated[list[Text], msgspec.Meta(max_length=64)]
    space: Annotated[str, msgspec.Meta(pattern="^[0-9a-f]{24}$")]
    control: Control | None = None
    dense: Dense | None = None
    made_of: Annotated[list[Text], msgspec.Meta(max_length=1000)] = []


def space_digest(space: ParameterSpace, /) -> str:
    """A name for exactly this generic head with its parts and rules, 24 hexadecimal digits."""
    state = hashlib.blake2b(digest_size=12)
    for array in (space.points, space.triangles, *(part.points for part in space.parts.values())):
        state.update(np.ascontiguousarray(array).data)
    state.update(repr((*space.parts, *space.rules)).encode())
    return state.hexdigest()


def to_dense(expression: Expression, /) -> Dense:
    """Converts an expression to its dense document, without the vertices at rest."""
    moved = np.flatnonzero((expression.dtheta != 0.0) | (expression.dh != 0.0) | (expression.ratio != 1.0))
    fields = (getattr(expression, name)[moved].tolist() for name in ("dtheta", "dh", "ratio"))
    yaw_left, pitch_left, yaw_right, pitch_right = expression.eyes.ravel().tolist()
    return Dense(
        sheet=Sheet(moved.tolist(), *fields),
        inner=_rest(expression.residual),
        parts={name: _rest(values) for name, values in sorted(expression.parts.items()) if values.any()},
        eyes=(yaw_left, pitch_left, yaw_right, pitch_right),
        pupil=expression.pupil,
        radius=msgspec.convert(expression.radius, Literal["origin", "surface"]),
        transfer=msgspec.convert(expression.transfer, Literal["smooth", "paper"]),
        ears=msgspec.convert(_turns(expression.ears), tuple[float, float, float, float, float, float] | None),
        head=msgspec.convert(_turns(expression.head), tuple[float, float, float] | None),
        complexion=expression.complexion if any(expression.complexion) else None,
    )


def _turns(angles: NDArray[np.float64]) -> list[float] | None:
    return angles.ravel().tolist() if angles.any() else None


def from_dense(space: ParameterSpace, dense: Dense, /) -> Expression:
    """Converts a dense document to an expression on its own head; ValueError where rows or lengths do not match.

    space: of its own head; dense: the document's.
    """
    sheet = dense.sheet
    count = space.vertex_count
    rows = _validate_rows(sheet.rows, count, "the sheet", (sheet.dtheta, sheet.dh, sheet.ratio))
    if not space.on_sheet[rows].all():
        raise ValueError("the sheet of the document has rows of inner skin; export it anew")
    fields = {name: np.full(count, rest) for name, rest in (("dtheta", 0.0), ("dh", 0.0), ("ratio", 1.0))}
    for name, values in fields.items():
        values[rows] = getattr(sheet, name)
    strange = sorted(dense.parts.keys() - space.parts.keys())
    if strange:
        raise ValueError(f"the document moves a part {strange[0]!r}; expected some of {', '.join(space.parts)}")
    return Expression(
        dtheta=fields["dtheta"],
        dh=fields["dh"],
        ratio=fields["ratio"],
        residual=_scatter(dense.inner, len(space.inner.vertices), "inner skin"),
        parts={name: _scatter(rest, len(space.parts[name].points), name) for name, rest in dense.parts.items()},
        eyes=np.reshape(dense.eyes, (2, 2)),
        radius=dense.radius,
        transfer=dense.transfer,
        pupil=dense.pupil,
        ears=np.reshape(dense.ears or np.zeros(6), (2, 3)),
        head=np.array(dense.head or np.zeros(3)),
        complexion=check_complexion(dense.complexion or PALE),
    )


def encode(document: ExpressionFile, /) -> bytes:
    """Encodes a document as JSON; ValueError where it holds what readers would reject."""
    data = msgspec.json.format(msgspec.json.encode(document), indent=0) + b"\n"
    decode(data)
    return data


def decode(data: bytes, /) -> ExpressionFile:
    """Decodes and validates a JSON document; ValueError for invalid ones, NaN and infinite numbers included."""
    if len(data) > LARGEST:
        raise ValueError(f"the document has {len(data)} bytes; expected {LARGEST} at most")
    try:
        return msgspec.json.decode(data, type=ExpressionFile)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        foreign = "it is JSON of another program" if b'"omote"' not in data else None
        why = explain_syntax(data) or foreign or explain_error(error)
        raise ValueError(f"{why}; expected an expression of Omote as docs/exchange.md has it") from error


def schema() -> bytes:
    """The JSON Schema of documents, as docs/expression.schema.json holds it."""
    document = {"$schema": "https://json-schema.org/draft/2020-12/schema", **msgspec.json.schema(ExpressionFile)}
    return msgspec.json.format(msgspec.json.encode(document), indent=2) + b"\n"


def _rest(values: NDArray[np.float64]) -> Rest:
    moved = np.flatnonzero(values.any(axis=1))
    return Rest(moved.tolist(), [(x, y, z) for x, y, z in values[moved].tolist()])


def _scatter(rest: Rest, count: int, what: str) -> NDArray[np.float64]:
    values = np.zeros((count, 3))
    rows = _validate_rows(rest.rows, count, what, (rest.moves,))
    if len(rows):
        values[rows] = rest.moves
    return values


def _validate_rows(rows: list[int], count: int, what: str, columns: tuple[list[Any], ...]) -> NDArray[np.int64]:
    indices = np.array(rows, np.int64)
    if any(len(column) != len(rows) for column in columns):
        raise ValueError(f"the rows of {what} and their values differ in number; export the document anew")
    if len(indices) and (indices.max() >= count or len(np.unique(indices)) < len(indices)):
        raise ValueError(f"the rows of {what} are not {count} at most, each once; export the document anew")
    return indices
