"""Packs own expressions, faces and poses as bytes (contents) for storage and the workshop, named by their hash.

`OMOC`, a version, then zlib over MessagePack: arrays little-endian, an expression's as float64 so that it comes back
exactly, and only the rows that move; a face's as float32, as faces are kept; the picture on its skin is a PNG. The same
object gives the same bytes.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.png import png_bytes, read_png
from omote.model.albedo import SIDES, Albedo
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.cast import Look
from omote.model.space.complexion import PALE, ComplexionNumbers, check_complexion
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.gain import Gain, check_gain_region
from omote.showfile.changes import Kind

MAGIC = b"OMOC"
VERSION = 1
MOST_BYTES = 2**25
"""Of what is unpacked: a dozen times the built-in cast's largest face; a decompression bomb is rejected before it is
unpacked."""
MOST_NUMBERS = 2**22
"""In all arrays together: rows at rest take no bytes, so they are counted apart."""

Numbers = NDArray[np.floating[Any]]
DOUBLE = np.dtype("<f8")
SINGLE = np.dtype("<f4")


class ContentError(ValueError):
    """The bytes are not a valid content; the message says why."""


class _Array(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    """shape; places: u32 rows that do not rest, or None for all; values of these rows."""

    shape: tuple[int, ...]
    places: bytes | None
    values: bytes


class _Expression(
    msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, tag_field="kind", tag="expression"
):
    dtheta: _Array
    dh: _Array
    ratio: _Array
    residual: _Array
    parts: dict[str, _Array]
    eyes: _Array
    radius: str
    transfer: str
    pupil: float
    ears: _Array | None = None
    head: _Array | None = None
    complexion: ComplexionNumbers | None = None


class _Gain(msgspec.Struct, frozen=True, array_like=True, forbid_unknown_fields=True):
    region: str
    value: float
    expression: str | None


class _Face(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, tag_field="kind", tag="face"):
    positions: _Array
    parts: dict[str, _Array]
    look: dict[str, str | float]
    gains: tuple[_Gain, ...] = ()
    albedo: bytes | None = None


_Content = _Expression | _Face | PoseRecipe


def content_kind(data: bytes, /) -> Kind:
    """The kind of a content; ContentError for invalid bytes."""
    return _kind_of(_decompress(data))


def _kind_of(content: _Content) -> Kind:
    if isinstance(content, PoseRecipe):
        return "pose"
    return "face" if isinstance(content, _Face) else "expression"


def pack_pose(recipe: PoseRecipe, /) -> bytes:
    """Packs a pose: its recipe, which is all of it."""
    return _compress(recipe)


def unpack_pose(data: bytes, /) -> PoseRecipe:
    """Unpacks a pose; ContentError for invalid bytes."""
    packed = _decompress(data)
    if not isinstance(packed, PoseRecipe):
        raise ContentError(f"this content is of another kind: {_kind_of(packed)}; expected a pose")
    return packed


def pack_expression(expression: Expression, /) -> bytes:
    """Packs an expression."""
    whole = {name: _sparse(getattr(expression, name)) for name in ("dtheta", "dh", "residual")}
    parts = {name: _sparse(expression.parts[name]) for name in sorted(expression.parts)}
    return _compress(
        _Expression(
            **whole,
            ratio=_sparse(expression.ratio, rest=1.0),
            parts=parts,
            eyes=_dense(expression.eyes, DOUBLE),
            radius=expression.radius,
            transfer=expression.transfer,
            pupil=expression.pupil,
            ears=_unless_still(expression.ears),
            head=_unless_still(expression.head),
            complexion=expression.complexion if any(expression.complexion) else None,
        )
    )


def unpack_expression(data: bytes, /) -> Expression:
    """Unpacks an expression exactly; ContentError for invalid bytes.

    That it fits a space is checked where it is used.
    """
    packed = _decompress(data)
    if not isinstance(packed, _Expression):
        raise ContentError(f"this content is of another kind: {_kind_of(packed)}; expected an expression")
    ears = packed.ears or _dense(np.zeros((2, 3)), DOUBLE)
    head = packed.head or _dense(np.zeros(3), DOUBLE)
    _refuse_too_many(
        packed.dtheta, packed.dh, packed.ratio, packed.residual, packed.eyes, ears, head, *packed.parts.values()
    )
    try:
        return Expression(
            dtheta=_fill(packed.dtheta),
            dh=_fill(packed.dh),
            ratio=_fill(packed.ratio, rest=1.0),
            residual=_fill(packed.residual),
            parts={name: _fill(part) for name, part in packed.parts.items()},
            eyes=_fill(packed.eyes),
            radius=packed.radius,
            transfer=packed.transfer,
            pupil=packed.pupil,
            ears=_fill(ears),
            head=_fill(head),
            complexion=check_complexion(packed.complexion or PALE),
        )
    except (ValueError, TypeError) as error:
        raise ContentError(f"this content holds no expression: {error}") from error


def pack_face(face: Face, look: Look, /) -> bytes:
    """Packs a face with its gains and its look, without its name."""
    parts = {name: _dense(face.parts[name], SINGLE) for name in sorted(face.parts)}
    gains = tuple(_Gain(gain.region, gain.value, gain.expression) for gain in face.gains)
    traits = {name: value for name, value in vars(look).items() if name != "albedo"}
    albedo = None if look.albedo is None else _pack_albedo(look.albedo)
    return _compress(_Face(_dense(face.positions, SINGLE), parts, traits, gains, albedo))


def unpack_face(data: bytes, /, name: str) -> tuple[Face, Look]:
    """Unpacks a face, under a name, and its look; ContentError for invalid bytes.

    That it fits a space, and that the cast has its hair, is checked where it is used.

    data: the content; name: of the face.
    """
    packed = _decompress(data)
    if not isinstance(packed, _Face):
        raise ContentError(f"this content is of another kind: {_kind_of(packed)}; expected a face")
    _refuse_too_many(packed.positions, *packed.parts.values())
    try:
        parts = {part: _fill(points, dtype=SINGLE) for part, points in packed.parts.items()}
        gains = tuple(Gain(check_gain_region(row.region), row.value, row.expression) for row in packed.gains)
        return Face(name, _fill(packed.positions, dtype=SINGLE), parts, gains), _look(packed.look, packed.albedo)
    except (ValueError, TypeError) as error:
        raise ContentError(f"this content holds no face: {error}") from error


def read_albedo(data: bytes, /) -> bytes | None:
    """The picture on the skin of a face, a PNG, None where it has none; ContentError for invalid bytes."""
    packed = _decompress(data)
    return packed.albedo if isinstance(packed, _Face) else None


@lru_cache(maxsize=4)
def _pack_albedo(albedo: Albedo) -> bytes:
    """A picture as a PNG; the last ones stay, for while an artist drags a handle it is the same again and again."""
    return png_bytes(albedo.pixels)


@lru_cache(maxsize=4)
def _unpack_albedo(data: bytes) -> Albedo:
    return Albedo(read_png(data, sides=SIDES))


def _look(traits: Mapping[str, Any], albedo: bytes | None) -> Look:
    strange = [name for name in traits if name not in Look.__dataclass_fields__ or name == "albedo"]
    if strange:
        raise ContentError(f"its look has {strange[0]!r}, which this Omote does not know: update Omote")
    for what in ("hair_style", "garment"):
        if not isinstance(traits.get(what, ""), str):
            raise ContentError(f"{what} of its look is {traits[what]!r}; expected a name")
    return Look(**traits, albedo=None if albedo is None else _unpack_albedo(albedo))


def _compress(content: _Content) -> bytes:
    plain = msgspec.msgpack.encode(content)
    if len(plain) > MOST_BYTES:
        raise ContentError(f"this content takes {len(plain)} bytes; expected at most {MOST_BYTES}: use fewer vertices")
    return MAGIC + bytes([VERSION]) + zlib.compress(plain, 6)


def _decompress(data: bytes) -> _Content:
    if data[: len(MAGIC)] != MAGIC or len(data) <= len(MAGIC):
        raise ContentError(f"these {len(data)} bytes do not begin as a content does; expected one that Omote packed")
    if data[len(MAGIC)] != VERSION:
        raise ContentError(
            f"this content has version {data[len(MAGIC)]}; this Omote reads version {VERSION}: update Omote"
        )
    try:
        content: _Content = msgspec.msgpack.decode(_inflate(data[len(MAGIC) + 1 :]), type=_Content)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ContentError(
            f"this content cannot be read ({explain_error(error)}); expected one that Omote packed"
        ) from error
    return content


def _inflate(packed: bytes) -> bytes:
    inflater = zlib.decompressobj()
    try:
        plain = inflater.decompress(packed, MOST_BYTES)
    except zlib.error as error:
        raise ContentError(f"this content is damaged ({explain_error(error)}); take it from another copy") from error
    if inflater.unconsumed_tail:
        raise ContentError(f"this content unpacks to more than {MOST_BYTES} bytes; expected less")
    if not inflater.eof or inflater.unused_data:
        what = "goes on after its end" if inflater.eof else "is cut off"
        raise ContentError(f"this content {what}; take it from another copy")
    return plain


def _unless_still(values: Numbers) -> _Array | None:
    """None for what is all rest, to the bit: contents of before say nothing of it."""
    return _dense(values, DOUBLE) if np.ascontiguousarray(values, DOUBLE).view("<u8").any() else None


def _dense(values: Numbers, dtype: np.dtype[Any]) -> _Array:
    return _Array(values.shape, None, _split_bytes(np.asarray(values, dtype)))


def _sparse(values: Numbers, rest: float = 0.0) -> _Array:
    """Only the rows whose bits differ from rest, where these are fewer; -0.0 is none of rest's."""
    double = np.ascontiguousarray(values, DOUBLE)
    moved = double.view("<u8") != np.array(rest, DOUBLE).view("<u8")
    places = np.flatnonzero(moved.reshape(len(double), -1).any(axis=1)) if double.size else np.empty(0, np.intp)
    if 2 * len(places) > len(double):
        return _dense(double, DOUBLE)
    return _Array(double.shape, places.astype("<u4").tobytes(), _split_bytes(double[places]))


def _split_bytes(values: Numbers) -> bytes:
    """Groups the first bytes of all numbers, then the second ones, ... (byte shuffle): this compresses better."""
    return np.ascontiguousarray(values).view(np.uint8).reshape(-1, values.itemsize).T.tobytes()


def _refuse_too_many(*arrays: _Array) -> None:
    total = 0
    for array in arrays:
        if len(array.shape) > 2 or any(not 0 <= length <= MOST_NUMBERS for length in array.shape):
            raise ContentError(f"an array of this content has shape {array.shape}; expected rows of numbers")
        total += int(np.prod(array.shape, dtype=np.int64))
    if total > MOST_NUMBERS:
        raise ContentError(f"this content holds {total} numbers; expected at most {MOST_NUMBERS}")


def _fill(array: _Array, *, rest: float = 0.0, dtype: np.dtype[Any] = DOUBLE) -> NDArray[Any]:
    """Rebuilds the whole array; ContentError where rows or values do not match its shape."""
    result = np.full(array.shape, rest, dtype)
    rows = np.arange(len(result)) if array.places is None else _places(array.places, len(result))
    width = result[:1].size or 1
    if len(array.values) != len(rows) * width * dtype.itemsize:
        raise ContentError(f"an array of shape {array.shape} has {len(array.values)} bytes for {len(rows)} rows")
    raw = np.frombuffer(array.values, np.uint8).reshape(dtype.itemsize, -1).T
    result[rows] = np.ascontiguousarray(raw).view(dtype).reshape(result[rows].shape)
    return result


def _places(data: bytes, count: int) -> NDArray[np.int64]:
    if len(data) % 4:
        raise ContentError(f"the places of an array have {len(data)} bytes; expected four for each")
    places = np.frombuffer(data, "<u4").astype(np.int64)
    if len(places) and (places[-1] >= count or (np.diff(places) <= 0).any()):
        raise ContentError(f"the places of an array are not rows 0 to {count - 1}, each once and rising")
    return places
