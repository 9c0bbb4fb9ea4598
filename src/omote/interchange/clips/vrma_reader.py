"""Reads VRM Animations (.vrma) of strangers: a GLB whose nodes are a humanoid, expressions and a gaze that move.

VRM Consortium, VRMC_vrm_animation-1.0:
https://github.com/vrm-c/vrm-specification/tree/master/specification/VRMC_vrm_animation-1.0
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import msgspec
import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from omote.arrays import Values
from omote.interchange.clips.humanoid_motion import HIPS, LEGS, PARENTS, HumanoidMotion, check_size, turns_of_worlds
from omote.interchange.formats.error_reasons import explain_error
from omote.interchange.formats.gltf_document import (
    AccessorReader,
    Document,
    Whole,
    entry,
    node_places,
    parse_document_as,
    split_gltf,
)
from omote.interchange.formats.gltf_extensions import extends
from omote.interchange.formats.gltf_scene import find_nothing, read_buffers
from omote.perform.clips.motion_curve import LONGEST_CURVE

EXTENSION = "VRMC_vrm_animation"
SLOWEST = 30.0
FASTEST = 60.0
"""Frames of a second that are read, whatever a file has: its curves are sampled."""
MOST_KEYS = 2**20
"""Of one curve."""
MOST_NODES = 2000
MOST_EXPRESSIONS = 500
MOST_CURVE_NUMBERS = 2**23
"""Of all curves together."""
_COLUMNS = {"rotation": 4, "translation": 3}


class Target(msgspec.Struct, frozen=True):
    """What a curve moves: a property of a node; other properties and targets move nothing here."""

    path: str
    node: Whole | None = None


class Channel(msgspec.Struct, frozen=True):
    """A curve and what it moves."""

    sampler: Whole
    target: Target


class Sampler(msgspec.Struct, frozen=True):
    """A curve: the accessors of its times and of its values."""

    input: Whole
    output: Whole
    interpolation: Literal["LINEAR", "STEP", "CUBICSPLINE"] = "LINEAR"


class Animation(msgspec.Struct, frozen=True):
    """Curves that play together."""

    channels: list[Channel]
    samplers: list[Sampler]


class AnimationDocument(Document, frozen=True, rename="camel"):
    """A glTF document with animations."""

    animations: tuple[Animation, ...] = ()


class _NodeOf(msgspec.Struct, frozen=True):
    node: Whole


class _Humanoid(msgspec.Struct, frozen=True, rename="camel"):
    human_bones: dict[str, _NodeOf]


class _Expressions(msgspec.Struct, frozen=True):
    preset: dict[str, _NodeOf] = {}
    custom: dict[str, _NodeOf] = {}


class _Extension(msgspec.Struct, frozen=True, rename="camel"):
    humanoid: _Humanoid | None = None
    expressions: _Expressions | None = None
    look_at: _NodeOf | None = None


def vrma_motion(data: bytes) -> HumanoidMotion:
    """The motion of a VRM Animation, of its first animation.

    data: the file.

    Returns
    -------
    HumanoidMotion
        Sampled evenly, 30 to 60 frames a second. Weights by the names of VRM: `happy`, `aa`, and those of its own.

    Raises
    ------
    ValueError
        For what is no GLB with the extension, and where nodes, curves or numbers are not valid or too many.
    """
    text, binary = split_gltf(data)
    document = parse_document_as(AnimationDocument, text)
    extension = _extension(document)
    if len(document.nodes) > MOST_NODES:
        raise ValueError(
            f"the file has {len(document.nodes)} nodes; expected {MOST_NODES} at most: export one humanoid"
        )
    if not document.animations:
        raise ValueError("the file has no animation; export the motion, too")
    bones = {} if extension.humanoid is None else extension.humanoid.human_bones
    nodes = {bone: _node(document, at.node) for bone, at in bones.items() if bone in PARENTS}
    if HIPS not in nodes:
        raise ValueError("the file names no hips among its bones; export a whole humanoid")
    reader = _Curves(document, binary)
    times = reader.grid()
    check_size(len(times), len(nodes))
    rest = node_places(document)
    parents = {child: at for at, node in enumerate(document.nodes) for child in node.children}
    worlds = _WorldTurns(document, parents, reader, times)
    told = {
        bone: worlds.turn(at) * Rotation.from_matrix(_rotation(rest[at])).inv() for bone, at in nodes.items()
    }  # fmt: skip
    names, turns = turns_of_worlds(told)
    leg = _leg(nodes, rest)
    hips = (worlds.place(nodes[HIPS]) - rest[nodes[HIPS]][:3, 3]) / leg
    weights, gaze = _face(document, extension, reader, times)
    return HumanoidMotion(times, names, turns, hips, weights, gaze)


def _extension(document: AnimationDocument) -> _Extension:
    told = extends(document.extensions, EXTENSION)
    if told is None:
        raise ValueError(f"the file has no {EXTENSION}, so it is no VRM Animation; export it as .vrma")
    try:
        return msgspec.convert(told, _Extension)
    except msgspec.ValidationError as error:
        raise ValueError(f"{EXTENSION} of the file is not valid ({explain_error(error)}); export it anew") from error


def _node(document: Document, at: int) -> int:
    entry(document.nodes, at, "node")
    return at


def _leg(nodes: Mapping[str, int], rest: Mapping[int, Values]) -> float:
    """The length of a leg at rest; where there are no legs, the height of the hips, which is about as much."""
    places = {bone: rest[at][:3, 3] for bone, at in nodes.items()}
    if set(LEGS) <= places.keys():
        chain = [[places[bone] for bone in LEGS if bone.startswith(side)] for side in ("left", "right")]
        leg = float(np.linalg.norm(np.diff(np.array(chain), axis=1), axis=2).sum() / 2.0)
    else:
        leg = float(places[HIPS][1])
    if not leg > 1e-6:
        raise ValueError("the legs of the file have no length; export it with its T-pose as its rest")
    return leg


def _rotation(place: Values) -> Values:
    """The rotation in a matrix (4, 4) with scale; ValueError where it has none."""
    u, sizes, v = np.linalg.svd(place[:3, :3])
    if sizes.min() < 1e-9 or np.linalg.det(u @ v) < 0.0:
        raise ValueError("a bone of the file is scaled to nothing or mirrored at rest; export it anew")
    return np.asarray(u @ v)


def _face(
    document: AnimationDocument, extension: _Extension, reader: _Curves, times: Values
) -> tuple[dict[str, Values], Values | None]:
    """The weights of expressions, and the gaze (n, 2) where there is one."""
    told = extension.expressions or _Expressions()
    named = {**told.custom, **told.preset}
    if len(named) > MOST_EXPRESSIONS:
        raise ValueError(f"the file moves {len(named)} expressions; expected {MOST_EXPRESSIONS} at most")
    weights: dict[str, Values] = {}
    for name, at in named.items():
        moved = reader.values(_node(document, at.node), "translation", times)
        if moved is not None:
            weights[name] = np.clip(moved[:, 0], 0.0, 1.0)
    looks = extension.look_at
    turned = None if looks is None else reader.values(_node(document, looks.node), "rotation", times)
    if turned is None:
        return weights, None
    ahead = Rotation.from_quat(turned).apply([0.0, 0.0, 1.0])
    yaw = np.arctan2(ahead[:, 0], ahead[:, 2])
    pitch = np.arcsin(np.clip(ahead[:, 1], -1.0, 1.0))
    return weights, np.column_stack([yaw, pitch])


class _Curves:
    """The curves of a document's first animation, by what they move."""

    def __init__(self, document: AnimationDocument, binary: bytes) -> None:
        self._reader = AccessorReader(document, read_buffers(document, binary, find_nothing))
        self._curves: dict[tuple[int, str], tuple[Values, Values, str]] = {}
        animation = document.animations[0]
        numbers = 0
        for channel in animation.channels:
            node = channel.target.node
            path = channel.target.path
            if node is None or path not in _COLUMNS:
                continue
            sampler = entry(animation.samplers, channel.sampler, "sampler")
            numbers += entry(document.accessors, sampler.output, "accessor").count * _COLUMNS[path]
            if numbers > MOST_CURVE_NUMBERS:
                raise ValueError(f"the curves of the file have more than {MOST_CURVE_NUMBERS} numbers; cut it in two")
            self._curves[_node(document, node), path] = self._read(sampler, path)
        if not self._curves:
            raise ValueError("nothing moves in the animation of the file; export the motion, too")

    def grid(self) -> Values:
        """Even times (n,) from 0 to where the last curve ends."""
        end = max(times[-1] for times, _, _ in self._curves.values())
        steps = [float(np.median(np.diff(times))) for times, _, _ in self._curves.values() if len(times) > 1]
        rate = min(max(1.0 / max(min(steps, default=1.0), 1e-3), SLOWEST), FASTEST)
        count = round(float(end) * rate) + 1
        return np.arange(count) / rate

    def values(self, node: int, path: str, times: Values) -> Values | None:
        """What a property of a node is at some times (n, 3 or 4); None where nothing moves it."""
        found = self._curves.get((node, path))
        if found is None:
            return None
        keys, values, kind = found
        at = np.clip(times, keys[0], keys[-1])
        before = np.clip(np.searchsorted(keys, at, side="right") - 1, 0, max(len(keys) - 2, 0))
        if kind == "STEP" or len(keys) == 1:
            last = np.clip(np.searchsorted(keys, at, side="right") - 1, 0, len(keys) - 1)
            return np.asarray(values[last, 1])
        step = keys[before + 1] - keys[before]
        u = ((at - keys[before]) / step)[:, None]
        first = values[before]
        second = values[before + 1]
        if kind == "CUBICSPLINE":
            bends = (u**3 - 2 * u**2 + u) * step[:, None] * first[:, 2] + (u**3 - u**2) * step[:, None] * second[:, 0]
            mixed = (2 * u**3 - 3 * u**2 + 1) * first[:, 1] + (3 * u**2 - 2 * u**3) * second[:, 1] + bends
            return np.asarray(mixed)
        if path == "rotation":
            return np.asarray(Slerp(keys, Rotation.from_quat(values[:, 1]))(at).as_quat())
        return np.asarray(first[:, 1] + u * (second[:, 1] - first[:, 1]))

    def _read(self, sampler: Sampler, path: str) -> tuple[Values, Values, str]:
        """The times of a curve, its values with the slopes before and behind (k, 3, columns), and its kind."""
        columns = _COLUMNS[path]
        keys = self._reader.numbers(sampler.input, 1, "the times of a curve", MOST_KEYS)[:, 0]
        cubic = sampler.interpolation == "CUBICSPLINE"
        told = self._reader.numbers(sampler.output, columns, "the values of a curve", 3 * MOST_KEYS, normalized=False)
        if len(told) != len(keys) * (3 if cubic else 1) or (np.diff(keys) <= 0.0).any():
            raise ValueError(
                "a curve of the file has times that do not rise, or another number of values; export it anew"
            )
        if keys[0] < 0.0 or keys[-1] > LONGEST_CURVE:
            raise ValueError(
                f"a curve of the file goes from {keys[0]:g} to {keys[-1]:g} s; expected 0 to {LONGEST_CURVE:g} s"
            )
        if path == "rotation":
            lengths = np.linalg.norm(told[1::3] if cubic else told, axis=1)
            if lengths.min() < 1e-6:
                raise ValueError("a curve of the file has a rotation of length 0; export it anew")
        if cubic:
            return keys, told.reshape(len(keys), 3, columns), sampler.interpolation
        return keys, np.repeat(told[:, None], 3, axis=1), sampler.interpolation


class _WorldTurns:
    """Where nodes are and how they are turned in each frame, as far as rotations and places move them."""

    def __init__(self, document: Document, parents: Mapping[int, int], reader: _Curves, times: Values) -> None:
        self._document = document
        self._parents = parents
        self._reader = reader
        self._times = times
        self._turns: dict[int, Rotation] = {}

    def turn(self, at: int) -> Rotation:
        """The rotations of a node, (n,), along the axes of the house."""
        for node in reversed(self._chain(at)):
            if node in self._turns:
                continue
            told = self._reader.values(node, "rotation", self._times)
            still = np.zeros((len(self._times), 3))
            local = Rotation.from_rotvec(still) * self._rest(node)[0] if told is None else Rotation.from_quat(told)
            above = self._parents.get(node)
            self._turns[node] = local if above is None else self._turns[above] * local
        return self._turns[at]

    def place(self, at: int) -> Values:
        """Where a node is, (n, 3), as its scene has it."""
        found = np.zeros((len(self._times), 3))
        for node in self._chain(at):
            _, sizes, place = self._rest(node)
            moved = self._reader.values(node, "translation", self._times)
            told = self._reader.values(node, "rotation", self._times)
            local = self._rest(node)[0] if told is None else Rotation.from_quat(told)
            found = (place if moved is None else moved) + local.apply(found * sizes)
        return found

    def _chain(self, at: int) -> list[int]:
        chain = [at]
        while chain[-1] in self._parents:
            chain.append(self._parents[chain[-1]])
        return chain

    def _rest(self, at: int) -> tuple[Rotation, Values, Values]:
        """Rotation, scale and place of a node against its parent at rest."""
        node: Any = self._document.nodes[at]
        if node.matrix is None:
            length = float(np.linalg.norm(node.rotation))
            turn = Rotation.from_quat(node.rotation) if length > 1e-6 else Rotation.identity()
            return turn, np.array(node.scale), np.array(node.translation)
        matrix = np.array(node.matrix).reshape(4, 4).T
        return Rotation.from_matrix(_rotation(matrix)), np.linalg.norm(matrix[:3, :3], axis=0), matrix[:3, 3]
