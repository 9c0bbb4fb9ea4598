"""The cast that plays: the built-in faces and expressions, and the crew's own ones from the show file."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from types import MappingProxyType

import msgspec

from omote.model.body.body import Body
from omote.model.body.compose_pose import pose_of
from omote.model.body.pose import Pose
from omote.model.cast import Cast
from omote.model.known_names import NEUTRAL, KnownNames
from omote.model.recipes.recipe import KEY
from omote.model.space.expression import Expression, Title
from omote.perform.name_lookup import OWN
from omote.show.cast_documents import ExpressionDocument, FaceDocument, Manifest
from omote.showfile.changes import Kind
from omote.showfile.contents import unpack_expression, unpack_face, unpack_pose
from omote.stage_data.assets import expression_document
from omote.stage_data.figure_documents import pose_document


class Own(msgspec.Struct, frozen=True):
    """An own face, expression or pose as it plays; content: the key of its bytes."""

    kind: Kind
    name: str
    label: str
    tags: tuple[str, ...]
    place: float
    content: str

    @property
    def source(self) -> str:
        """Its name in the addresses of compounds, and what pages know it by."""
        return KEY + self.content


class PlayingExpressions(Mapping[str, Expression]):
    """Expressions by name: the built-in ones, and own ones, which are unpacked lazily.

    own: keys of contents by name. An invalid content plays as neutral, for the show goes on.
    """

    def __init__(
        self, built_in: Mapping[str, Expression], own: Mapping[str, str], contents: Mapping[str, bytes]
    ) -> None:
        self._built_in = built_in
        self._own = own
        self._contents = contents
        self._unpacked: dict[str, Expression] = {}

    def __getitem__(self, name: str) -> Expression:
        key = self._own.get(name)
        if key is None:
            return self._built_in[name]
        if key not in self._unpacked:
            try:
                self.unpack(key)
            except (ValueError, KeyError):
                self._unpacked[key] = self._built_in[NEUTRAL]
        return self._unpacked[key]

    def __iter__(self) -> Iterator[str]:
        return chain(self._built_in, self._own)

    def __len__(self) -> int:
        return len(self._built_in) + len(self._own)

    def __contains__(self, name: object) -> bool:
        return name in self._own or name in self._built_in

    def learn(self, other: PlayingExpressions) -> None:
        """Takes over the expressions that another has unpacked."""
        keys = set(self._own.values())
        self._unpacked |= {key: expression for key, expression in other._unpacked.items() if key in keys}

    def unpack(self, key: str) -> None:
        """Unpacks a content now; ValueError where it does not fit this head, KeyError where it is missing."""
        if key not in self._unpacked:
            self._unpacked[key] = check_fit(self._built_in[NEUTRAL], unpack_expression(self._contents[key]))


@dataclass(frozen=True, eq=False)
class PlayingCast:
    """The built-in cast and own items beside it; made by `build_playing_cast`, plays as a cast does.

    expressions, poses: built-in and own; `faces` and `expression_sources`: for each name its source.
    """

    base: Cast
    own: tuple[Own, ...]
    faces: Mapping[str, str]
    expressions: PlayingExpressions
    expression_sources: Mapping[str, str]
    poses: Mapping[str, Pose]

    @cached_property
    def titles(self) -> Mapping[str, Title]:
        """What each expression is called and where it acts: own ones on the whole face."""
        own = {item.name: Title(item.label, OWN) for item in self.own if item.kind == "expression"}
        return MappingProxyType({**self.base.titles, **own})

    @cached_property
    def face_labels(self) -> Mapping[str, str]:
        """What the own faces are called."""
        return MappingProxyType({item.name: item.label for item in self.own if item.kind == "face"})

    @property
    def bodies(self) -> Mapping[str, Body]:
        """The bodies that can be called."""
        return self.base.bodies

    @property
    def bones(self) -> tuple[str, ...]:
        """The bones that poses turn, in their order."""
        return self.base.bones

    @cached_property
    def digest(self) -> str:
        """The digest of this cast: the built-in cast's where there are no own items."""
        return digest_of(self.base.digest, self.own)


def digest_of(base: str, own: tuple[Own, ...]) -> str:
    """The digest of a cast with own items, hexadecimal; the built-in cast's where there are none.

    base: the built-in cast's digest; own: the items beside it.
    """
    if not own:
        return base
    return hashlib.blake2b(base.encode() + msgspec.msgpack.encode(own), digest_size=12).hexdigest()


def build_playing_cast(
    base: Cast,
    own: tuple[Own, ...],
    contents: Mapping[str, bytes],
    *,
    before: PlayingCast | None = None,
    check: bool = True,
) -> PlayingCast:
    """Builds the cast with own items; before: what played until now, of which nothing is unpacked or checked again.

    check: new items are unpacked now; else when they are first used. Raises ValueError where a name is taken
    or a content does not fit the cast, KeyError where one is missing.

    base: the built-in cast; contents: bytes by key.
    """
    faces = {name: name for name in base.faces}
    expressions = {name: name for name in base.expressions}
    poses = {name: name for name in base.poses}
    keys: dict[str, str] = {}
    for item in own:
        names = {"face": faces, "expression": expressions, "pose": poses}[item.kind]
        if item.name in names:
            raise ValueError(f"there are two {item.kind}s named {item.name!r}; expected another name for one of them")
        names[item.name] = item.source
        if item.kind == "expression":
            keys[item.name] = item.content
    playing_expressions = PlayingExpressions(base.expressions, keys, contents)
    played = frozenset() if before is None else frozenset(item.content for item in before.own)
    if before is not None:
        playing_expressions.learn(before.expressions)
    for item in own:
        if check and item.content not in played:
            _check_content(base, item, contents, playing_expressions)
    sources = MappingProxyType(faces), playing_expressions, MappingProxyType(expressions)
    own_poses = {item.name: _own_pose(base, item, contents) for item in own if item.kind == "pose"}
    return PlayingCast(base, own, *sources, MappingProxyType(KnownNames("pose", {**base.poses, **own_poses})))


def labels_of(cast: Cast | PlayingCast) -> dict[Kind, dict[str, str]]:
    """What people read of faces and of expressions, by name."""
    own = cast.own if isinstance(cast, PlayingCast) else ()
    base = cast.base if isinstance(cast, PlayingCast) else cast
    expressions = {name: title.label for name, title in base.titles.items()}
    poses = {name: pose.label for name, pose in base.poses.items()}
    labels: dict[Kind, dict[str, str]] = {"face": {}, "expression": expressions, "pose": poses}
    for item in own:
        labels[item.kind][item.name] = item.label
    return labels


def kinds_of(cast: PlayingCast) -> dict[str, str]:
    """The kind of every expression, by name."""
    return {name: title.kind for name, title in cast.titles.items()}


def manifest_of(playing: PlayingCast, built_in: Manifest, faces: Mapping[str, FaceDocument]) -> Manifest:
    """The manifest with own items; faces: by the keys of their contents (`assets.content_asset`), others are left
    out.

    playing: the cast that plays; built_in: the manifest of the built-in cast.
    """
    own = [item for item in playing.own if item.kind == "face" and item.content in faces]
    figures = built_in.figures
    if figures is not None:
        poses = [pose_document(playing.poses[item.name], item.source) for item in playing.own if item.kind == "pose"]
        figures = msgspec.structs.replace(figures, poses=[*figures.poses, *poses])
    return msgspec.structs.replace(
        built_in,
        digest=playing.digest,
        figures=figures,
        faces=[*built_in.faces, *(_face_document(item, faces[item.content]) for item in own)],
        expressions=[*built_in.expressions, *(_document(playing, e) for e in playing.own if e.kind == "expression")],
    )


def check_fit(neutral: Expression, expression: Expression) -> Expression:
    """Returns an expression that is of the head of the neutral one; ValueError for any other."""
    count = len(neutral.dtheta)
    if len(expression.dtheta) != count or len(expression.residual) != len(neutral.residual):
        raise ValueError(f"the expression has {len(expression.dtheta)} vertices; expected the {count} of this cast")
    return expression


def _check_content(base: Cast, own: Own, contents: Mapping[str, bytes], expressions: PlayingExpressions) -> None:
    """Unpacks an item's content; ValueError where it does not fit the cast, KeyError where it is missing."""
    if own.kind == "pose":
        return  # made with the cast
    if own.kind == "expression":
        expressions.unpack(own.content)
        return
    count = len(unpack_face(contents[own.content], own.name)[0].positions)
    if count != base.space.vertex_count:
        raise ValueError(f"the face has {count} vertices; expected the {base.space.vertex_count} of this cast")


def _own_pose(base: Cast, own: Own, contents: Mapping[str, bytes]) -> Pose:
    """An own pose; ValueError where no figure of the cast can do it, KeyError where its content is missing."""
    if base.figures is None:
        raise ValueError("this cast has no figures; bake it again")
    return pose_of(unpack_pose(contents[own.content]), base.figures.space.skeleton, own.name, own.label)


def _face_document(own: Own, document: FaceDocument) -> FaceDocument:
    return msgspec.structs.replace(document, name=own.name, label=own.label, tags=list(own.tags), place=own.place)


def _document(playing: PlayingCast, own: Own) -> ExpressionDocument:
    expression = playing.expressions[own.name]
    title = playing.titles[own.name]
    document = expression_document(own.name, expression, title, own.source)
    return msgspec.structs.replace(document, tags=list(own.tags), place=own.place)
