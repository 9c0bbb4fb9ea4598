"""The meshes of a glTF document as viewers show them at rest: placed by nodes or joints, default weights worn."""

from __future__ import annotations

import base64
import binascii
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from omote.arrays import Values
from omote.interchange.formats.gltf_document import (
    MOST_VERTICES,
    AccessorReader,
    Document,
    Mesh,
    Node,
    Primitive,
    entry,
)
from omote.interchange.formats.gltf_extensions import COMPRESSED, extends, refusal_of

MOST_TARGETS = 1024
MOST_JOINTS = 4096
MOST_SETS = 4
"""Sets of four joints that may hold a vertex."""
_HELD = 1e-6
"""The sum of the weights of a vertex that some joint holds, at least."""

NodePlaces = Mapping[int, Values]
Find = Callable[[str], bytes | None]
Note = Callable[[str], None]


def find_nothing(_: str, /) -> bytes | None:
    """Beside a file that is bytes alone lies nothing."""
    return None


def note_nothing(_: str, /) -> None:
    """Tells nobody."""


class TargetNames(Protocol):
    """What the targets of nodes are called, and what is made of them."""

    def rename(self, node: int, names: Sequence[str], moves: Mapping[str, Values], /) -> Mapping[str, Values]:
        """What a node's targets, `names` in the order of the file, do under the names that count.

        node: its number; names: of the targets; moves (n, 3): by those names, metres.
        """


@dataclass(frozen=True, eq=False)
class RestingPrimitive:
    """One primitive where it stands at rest.

    points (n, 3), some of them no numbers where the file's are none; moves: what each target adds to them (n, 3) on
    its way from rest to its full weight; mirrored: its place turns its triangles inside out.
    """

    points: Values
    moves: Mapping[str, Values]
    mirrored: bool


class SceneReader(AccessorReader):
    """Reads the primitives of a document's nodes.

    document, buffers: the glTF and its bytes; named: what its targets are called, None: by their own names; note: takes
    a sentence about what is left out; most: vertices of a primitive.
    """

    def __init__(
        self, document: Document, buffers: Sequence[bytes], named: TargetNames | None = None, /, *,
        note: Note = note_nothing, most: int = MOST_VERTICES,
    ) -> None:  # fmt: skip
        super().__init__(document, buffers)
        self.named = named
        self.note = note
        self.most = most

    def at_rest(self, at: int, mesh: Mesh, primitive: Primitive, places: NodePlaces, /) -> RestingPrimitive:
        """A primitive of a node's mesh as a viewer shows it before anything moves.

        at: the node; mesh, primitive: that it shows; places: where each node stands, (4, 4).
        """
        with np.errstate(invalid="ignore", over="ignore"):  # of numbers that are none, which who asks sees to
            return self._at_rest(at, mesh, primitive, places)

    def _at_rest(self, at: int, mesh: Mesh, primitive: Primitive, places: NodePlaces) -> RestingPrimitive:
        node = self.document.nodes[at]
        points = self.numbers(primitive.attributes["POSITION"], 3, "POSITION", self.most, finite=False)
        count = len(points)
        names = target_names(mesh, primitive, self.note)
        weights = _default_weights(node, mesh, len(names))
        moves: dict[str, Values] = {}
        for name, target, weight in zip(names, primitive.targets, weights, strict=True):
            move = self._move(target, count)
            points = points + weight * move if weight else points
            if weight < 1.0:
                moves[name] = move if weight == 0.0 else (1.0 - weight) * move
            else:
                self.note(f"its shape {name[:80]!r} is worn at rest, so it is part of the face and no expression")
        placed = self._joints(primitive, node, count, places)
        turn, shift = _parts(places[at] if placed is None else placed)
        renamed = moves if self.named is None else self.named.rename(at, names, moves)
        return RestingPrimitive(
            points=turned(points, turn) + shift,
            moves={name: turned(move, turn) for name, move in renamed.items()},
            mirrored=bool(np.median(np.linalg.det(turn)) < 0.0),
        )

    def column(self, index: int, columns: int, what: str, count: int, **options: bool) -> Values:
        """The values (count, columns) of an accessor that has one for each vertex; ValueError for another count.

        index: the accessor's; columns: numbers of each; what: its name in a message; count: of vertices; options: of
        `numbers`.
        """
        column = self.numbers(index, columns, what, self.most, **options)
        if len(column) != count:
            raise ValueError(f"{what} has {len(column)} rows and its mesh {count} vertices; export it anew")
        return column

    def _move(self, target: Mapping[str, Any], count: int) -> Values:
        """What a target adds to positions; one without positions adds nothing."""
        if "POSITION" not in target:
            return np.zeros((count, 3))
        index = target["POSITION"]
        if not isinstance(index, int) or isinstance(index, bool):
            raise ValueError(f"a target has {index!r:.80} as its positions; expected a number: export it anew")
        return self.column(index, 3, "POSITION of a target", count, finite=False)

    def _joints(self, primitive: Primitive, node: Node, count: int, places: NodePlaces) -> Values | None:
        """Where the joints bring each vertex (n, 4, 4), None where nothing but its node places the mesh.

        What no joint holds follows the first, as three.js has it.
        """
        attributes = primitive.attributes
        sets = [at for at in range(MOST_SETS) if {f"JOINTS_{at}", f"WEIGHTS_{at}"} <= attributes.keys()]
        if node.skin is None or not sets:
            return None
        bones = self._bones(node.skin, places)
        weights = np.hstack([self._of_set(primitive, f"WEIGHTS_{at}", count, finite=False) for at in sets])
        weights = np.where(np.isfinite(weights) & (weights > 0.0), weights, 0.0)
        joints = np.hstack([self._of_set(primitive, f"JOINTS_{at}", count) for at in sets]).astype(np.int64)
        weights[weights.sum(axis=1) <= _HELD, 0] = 1.0
        used = np.where(weights > 0.0, joints, 0)
        if used.min() < 0 or used.max() >= len(bones):
            raise ValueError(f"a mesh names joint {used.max()} and its skin has {len(bones)}; export it anew")
        shares = weights / weights.sum(axis=1, keepdims=True)
        placed = np.zeros((count, 4, 4))
        for share, joint in zip(shares.T, used.T, strict=True):
            placed += share[:, None, None] * bones[joint]
        return placed

    def _of_set(self, primitive: Primitive, name: str, count: int, **options: bool) -> Values:
        return self.column(primitive.attributes[name], 4, name, count, **options)

    def _bones(self, index: int, places: NodePlaces) -> Values:
        """What each joint of a skin does to a mesh (j, 4, 4)."""
        skin = entry(self.document.skins, index, "skin")
        if len(skin.joints) > MOST_JOINTS:
            raise ValueError(f"a skin has {len(skin.joints)} joints; expected {MOST_JOINTS} at most")
        if not skin.joints or any(joint not in places for joint in skin.joints):
            raise ValueError("a skin of the file names joints that are none of its nodes; export it anew")
        bones = np.stack([places[joint] for joint in skin.joints])
        if skin.inverse_bind_matrices is None:
            return bones
        inverse = self.column(skin.inverse_bind_matrices, 16, "inverse bind matrices", len(bones))
        return bones @ inverse.reshape(-1, 4, 4).transpose(0, 2, 1)


def _parts(place: Values) -> tuple[Values, Values]:
    """The turn and the shift of one matrix, or of each."""
    return place[..., :3, :3], place[..., :3, 3]


def turned(points: Values, turn: Values, /) -> Values:
    """Points (n, 3) by one matrix (3, 3), or each by its own (n, 3, 3).

    points, turn: arrays.
    """
    result: Values = points @ turn.T if turn.ndim == 2 else np.einsum("nij,nj->ni", turn, points)
    return result


def _default_weights(node: Node, mesh: Mesh, count: int) -> list[float]:
    """The weights of a node's targets at rest: the node's own, else its mesh's, else none."""
    weights = mesh.weights if node.weights is None else node.weights
    return [*weights[:count], *[0.0] * (count - len(weights))]


def target_names(mesh: Mesh, primitive: Primitive, note: Note = note_nothing, /) -> list[str]:
    """The names of a primitive's targets, in order: those that the mesh's `extras` have, else the primitive's, where
    VRM 0 has them; one that is there twice gets a number, one without is `target_0` and so on.

    mesh, primitive: of a document; note: takes a sentence.
    """
    count = len(primitive.targets)
    if count > MOST_TARGETS:
        raise ValueError(f"mesh {mesh.name[:80]!r} has {count} targets; expected {MOST_TARGETS} at most")
    given = _given_names(mesh.extras, count) or _given_names(primitive.extras, count)
    names = list[str]()
    for at in range(count):
        name = given.get(at) or f"target_{at}"
        number = at
        unique = name
        while unique in names:
            unique = f"{name} {number}"
            number += 1
        if unique != name:
            note(f"two of its shapes are named {name[:80]!r}: the second is read as {unique[:90]!r}")
        names.append(unique)
    return names


def _given_names(extras: object, count: int) -> dict[int, str]:
    """Names by the number of their target, out of any JSON: a list of them, or a table of their numbers."""
    names = extras.get("targetNames") if isinstance(extras, dict) else None
    pairs: Sequence[tuple[object, object]] = []
    if isinstance(names, list):
        pairs = [*enumerate(names)]
    elif isinstance(names, dict):
        pairs = [(at, name) for name, at in names.items()]
    return {at: name for at, name in pairs if isinstance(at, int) and 0 <= at < count and isinstance(name, str)}


def read_buffers(document: Document, binary: bytes, find: Find, /) -> list[bytes]:
    """The bytes of each buffer of a document; ValueError where one is not there or is too short.

    document: the glTF; binary: the chunk of a GLB; find: the bytes of a name beside the file.
    """
    bodies = []
    for place, buffer in enumerate(document.buffers[:256]):
        inside = buffer.uri is None and place == 0
        body = binary if inside else None if buffer.uri is None else read_uri(buffer.uri, find)
        if body is None:
            packed = next((name for name in COMPRESSED if extends(buffer.extensions, name)), "")
            if packed:
                raise refusal_of(packed)
            name = (buffer.uri or f"buffer {place}")[-80:]
            raise ValueError(
                f"{name!r}, which holds its numbers, lies outside the file and does not lie beside it; export "
                "everything into one GLB"
            )
        if buffer.byte_length > len(body):
            raise ValueError(
                f"buffer {place} has {buffer.byte_length} bytes, and the file holds {len(body)}; export it anew"
            )
        bodies.append(body)
    return bodies


def read_uri(uri: str, find: Find, /) -> bytes | None:
    """The bytes that a URI holds (data:...;base64,...) or names; None where nothing of its name lies beside the file.

    ValueError for one that holds none.

    uri: as the document has it; find: the bytes of a name beside the file.
    """
    if not uri.startswith("data:"):
        return find(_unquote(uri))
    head, comma, body = uri.partition(",")
    if not comma or not head.endswith(";base64"):
        raise ValueError(f"the file holds bytes as {head[:80]!r}; expected base64: export it as .glb")
    try:
        return base64.b64decode(body, validate=True)
    except (binascii.Error, ValueError):
        raise ValueError("the file holds bytes in base64 that is damaged; export it anew, as .glb") from None


def _unquote(uri: str) -> str:
    """A name without percent signs for its blanks and letters (RFC 3986, section 2.1)."""
    plain = re.sub(
        rb"%([0-9A-Fa-f]{2})", lambda match: bytes.fromhex(match[1].decode()), uri.encode("utf-8", "replace")
    )
    return plain.decode("utf-8", "replace")
