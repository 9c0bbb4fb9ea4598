"""A cast as bytes, less the built-in one: what a worker elsewhere needs to have the same; and keys of its contents."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from dataclasses import replace

import msgspec

from omote.interchange.formats.expression_json import space_digest
from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.showfile.contents import pack_expression, pack_face, unpack_expression, unpack_face


class _OwnExpression(msgspec.Struct, frozen=True, array_like=True):
    name: str
    label: str
    kind: str
    region: str
    content: bytes


class _Own(msgspec.Struct, frozen=True, array_like=True):
    faces: dict[str, bytes]
    expressions: list[_OwnExpression]


def pack_own(cast: Cast, base: Cast, /) -> bytes:
    """What a cast has that its base has not, or has otherwise."""
    faces = {
        name: pack_face(face, cast.looks[name])
        for name, face in cast.faces.items()
        if face is not base.faces.get(name) or cast.looks[name] != base.looks.get(name)
    }
    titles = cast.titles
    own = [
        _OwnExpression(name, titles[name].label, titles[name].kind, titles[name].region, pack_expression(expression))
        for name, expression in cast.expressions.items()
        if expression is not base.expressions.get(name)
    ]
    return msgspec.msgpack.encode(_Own(faces, own))


def unpack_own(base: Cast, data: bytes, /) -> Cast:
    """The cast again, of the same base; ValueError where that is of another head.

    base: the cast that `pack_own` had; data: its bytes.
    """
    own = msgspec.msgpack.decode(data, type=_Own)
    unpacked = {name: unpack_face(content, name) for name, content in own.faces.items()}
    return replace(
        base,
        faces={**base.faces, **{name: face for name, (face, _) in unpacked.items()}},
        looks={**base.looks, **{name: look for name, (_, look) in unpacked.items()}},
        expressions={
            **base.expressions,
            **{expression.name: unpack_expression(expression.content) for expression in own.expressions},
        },
        titles={
            **base.titles,
            **{
                expression.name: Title(expression.label, expression.kind, expression.region)
                for expression in own.expressions
            },
        },
    )


def key_of_options(cast: Cast, expressions: Iterable[str], options: tuple[object, ...], /) -> str:
    """A key of what all faces of an export share: the head, the expressions, and options that say all the rest.

    cast: that has them.
    """
    state = hashlib.blake2b(repr((space_digest(cast.space), options)).encode(), digest_size=16)
    for name in expressions:
        state.update(repr((name, cast.titles[name])).encode() + pack_expression(cast.expressions[name]))
    return state.hexdigest()


def key_of_face(cast: Cast, face: str, shared: str, /) -> str:
    """A key of exactly what one face's export holds; shared: `key_of_options`. cast: that has it; face: its name."""
    look = cast.looks[face]
    state = hashlib.blake2b(repr((shared, face)).encode() + pack_face(cast.faces[face], look), digest_size=16)
    for array in cast.hair[look.hair_style].arrays if look.hair_style else ():
        state.update(array.tobytes())
    return state.hexdigest()
