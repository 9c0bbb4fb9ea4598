"""The cast that plays: the built-in one, and what crews have made themselves."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import msgspec

from omote.files.changes import Kind
from omote.files.contents import unpack_expression
from omote.model.cast import Cast, Title
from omote.model.expression import Expression
from omote.model.recipe import KEY
from omote.show.assets import expression_document
from omote.show.messages import ExpressionDocument, FaceDocument, Manifest

OWN = "own"


class Own(msgspec.Struct, frozen=True):
    """An own face or expression as it plays; content: the key of its bytes."""

    kind: Kind
    name: str
    label: str
    tags: tuple[str, ...]
    place: float
    content: str

    @property
    def source(self) -> str:
        """Its name in the addresses of compounds."""
        return KEY + self.content


@dataclass(frozen=True, eq=False)
class Troupe:
    """The built-in cast and own things beside it; made by `troupe_of`, plays as a cast does.

    expressions: built-in and own; `faces` and `expression_sources`: for each name its source.
    """

    base: Cast
    own: tuple[Own, ...]
    faces: Mapping[str, str]
    expressions: Mapping[str, Expression]
    expression_sources: Mapping[str, str]

    @cached_property
    def digest(self) -> str:
        """A name for exactly this cast: the built-in cast's where there is nothing else."""
        return digest_of(self.base.digest, self.own)

    def find(self, kind: Kind, name: str) -> Own | None:
        """The own thing of this name."""
        return next((each for each in self.own if (each.kind, each.name) == (kind, name)), None)


def digest_of(base: str, own: tuple[Own, ...]) -> str:
    """A name for a cast with own things, hexadecimal; that of the built-in cast where there are none."""
    if not own:
        return base
    return hashlib.blake2b(base.encode() + msgspec.msgpack.encode(own), digest_size=12).hexdigest()


def troupe_of(
    base: Cast, own: tuple[Own, ...], contents: Mapping[str, bytes], *, before: Troupe | None = None
) -> Troupe:
    """The cast with own things; what `before` holds already is not unpacked again.

    Raises ValueError where a name is taken or a content does not fit the cast, KeyError where one is missing.
    """
    faces = {name: name for name in base.faces}
    expressions, sources = dict(base.expressions), {name: name for name in base.expressions}
    known = {} if before is None else _unpacked(before)
    for each in own:
        names: Mapping[str, object] = faces if each.kind == "face" else sources
        if each.name in names:
            raise ValueError(f"there are two {each.kind}s named {each.name!r}; expected another name for one of them")
        if each.kind == "face":
            faces[each.name] = each.source
            continue
        expressions[each.name] = known.get(each.content) or _fitting(base, unpack_expression(contents[each.content]))
        sources[each.name] = each.source
    return Troupe(base, own, MappingProxyType(faces), MappingProxyType(expressions), MappingProxyType(sources))


def manifest_of(troupe: Troupe, built_in: Manifest, faces: Mapping[str, FaceDocument]) -> Manifest:
    """The manifest with own things; faces: by the keys of their contents (`assets.content_asset`), others are left
    out."""
    own = [each for each in troupe.own if each.kind == "face" and each.content in faces]
    return msgspec.structs.replace(
        built_in,
        digest=troupe.digest,
        faces=[*built_in.faces, *(_face_document(each, faces[each.content]) for each in own)],
        expressions=[*built_in.expressions, *(_document(troupe, e) for e in troupe.own if e.kind == "expression")],
    )


def _unpacked(troupe: Troupe) -> dict[str, Expression]:
    return {each.content: troupe.expressions[each.name] for each in troupe.own if each.kind == "expression"}


def _fitting(base: Cast, expression: Expression) -> Expression:
    space = base.space
    if len(expression.dtheta) != space.vertex_count or len(expression.residual) != len(space.inner.vertices):
        raise ValueError(
            f"the expression has {len(expression.dtheta)} vertices; expected the {space.vertex_count} of this cast"
        )
    return expression


def _face_document(own: Own, document: FaceDocument) -> FaceDocument:
    return msgspec.structs.replace(document, name=own.name, label=own.label, tags=list(own.tags), place=own.place)


def _document(troupe: Troupe, own: Own) -> ExpressionDocument:
    title = Title(own.label, OWN)
    document = expression_document(own.name, troupe.expressions[own.name], title, source=own.source)
    return msgspec.structs.replace(document, tags=list(own.tags), place=own.place)
