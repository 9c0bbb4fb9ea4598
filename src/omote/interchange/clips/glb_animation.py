"""Clips as animations of glTF: of an exported head, and as a VRM Animation (VRMA) for any avatar."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from omote.arrays import Floats, Values
from omote.interchange.clips.body_motion import AnimatedBody
from omote.interchange.clips.clip_frames import ClipFrames
from omote.interchange.clips.clip_names import quaternions_of
from omote.interchange.clips.humanoid_motion import HIPS, parent_among
from omote.interchange.export_face import ExportContext, Meshes, build_scene
from omote.interchange.formats.glb_writer import FLOAT, GENERATOR, Json, Store, describe_scene, encode_glb
from omote.model.known_names import NEUTRAL
from omote.perform.channels import GAZE_UNITS

EXTENSION = "VRMC_vrm_animation"
VERSION = "1.0"
SPINE = (("hips", 0.95), ("spine", 0.1), ("chest", 0.12), ("neck", 0.26), ("head", 0.12))
"""The bones that hold a head up, each with its height above the one below, metres: a VRMA has hips and what it turns,
and is worn by avatars of any size."""
PRESETS = {
    "joy": "happy", "angry": "angry", "sad": "sad", "smile": "relaxed", "surprise": "surprised",
}  # fmt: skip
"""Expressions that VRM has by other names, as our avatars have them."""


def used_names(frames: ClipFrames, names: Iterable[str]) -> list[str]:
    """The expressions and channels that a clip moves and that there are. frames: of it; names: those that there are."""
    there = set(names) - {NEUTRAL}
    return [name for name, values in frames.weights.items() if name in there and values.any()]


def animated_head(
    context: ExportContext, face: str, poses: Iterable[tuple[str, Meshes]], frames: ClipFrames, /, *, name: str
) -> bytes:
    """Encodes a face of the cast with a clip as the animation of its morph targets and of its root, as a GLB.

    Parameters
    ----------
    context : ExportContext
        What all exports of a cast share.
    face : str
        Of the cast.
    poses : iterable of (str, Meshes)
        `named_compound_meshes` of what the clip moves, with the units that turn the eyes, by name.
    frames : ClipFrames
        Of the clip.
    name : str
        Of the animation.

    Returns
    -------
    bytes
        Every mesh has all targets in one order, so one sampler moves them all: frames times targets numbers.

    Raises
    ------
    ValueError
        For a face that is not in the cast.
    """
    worn = dict(poses)
    scene = build_scene(context, face, worn.items(), hair=True, drawn=True)
    store = Store()
    document = describe_scene(scene, store)
    weights = frames.turning_eyes(context.cast.expressions)
    still = np.zeros(len(frames.times))
    table = np.column_stack([weights.get(target, still) for target in worn]) if worn else np.zeros((len(still), 0))
    animation = _Animation(store, frames.times, name)
    if worn:
        moved = animation.sampler(table.reshape(-1))
        for place, shape in enumerate(scene.shapes, 1):
            if shape.targets:
                animation.channel(moved, place, "weights")
    if frames.head.any():
        animation.channel(animation.sampler(quaternions_of(frames.head)), 0, "rotation")
    return encode_glb(document | animation.document(), store)


def vrm_animation(
    frames: ClipFrames, customs: Mapping[str, str], /, *, name: str, body: AnimatedBody | None = None
) -> bytes:
    """Encodes a clip as a VRM Animation: its bones, each expression as a node whose x is its weight, the gaze as the
    rotation of another.

    Parameters
    ----------
    frames : ClipFrames
        Of the clip; the units that turn the eyes are left out: the gaze turns them.
    customs : mapping of str
        What an avatar calls expressions and channels that are no presets of VRM: `EyeBlinkLeft`, by our names.
    name : str
        Of the animation.
    body : AnimatedBody, optional
        All bones, where the clip has a body; the head's alone without it.

    Returns
    -------
    bytes
        A GLB without meshes.

    References
    ----------
    VRM Consortium, VRMC_vrm_animation-1.0.
    """
    store = Store()
    animation = _Animation(store, frames.times, name)
    nodes = _head_bones() if body is None else _bone_nodes(body)
    bones = {node["name"]: {"node": place} for place, node in enumerate(nodes)}
    roots = [bones[HIPS]["node"]]
    if body is None:
        animation.channel(animation.sampler(quaternions_of(frames.head)), bones["head"]["node"], "rotation")
    else:
        _move_bones(animation, body)
    expressions: dict[str, dict[str, Json]] = {"preset": {}, "custom": {}}
    for ours, values in frames.weights.items():
        if ours in GAZE_UNITS or not values.any():
            continue
        kind, theirs = ("preset", PRESETS[ours]) if ours in PRESETS else ("custom", customs.get(ours, ours))
        roots.append(len(nodes))
        expressions[kind][theirs] = {"node": len(nodes)}
        moved = np.column_stack([values, np.zeros((len(values), 2))])
        animation.channel(animation.sampler(moved), len(nodes), "translation")
        nodes.append({"name": theirs})
    looks: Json = {}
    if body is None or frames.gaze.any():
        roots.append(len(nodes))
        looks = {"lookAt": {"node": len(nodes), "offsetFromHeadBone": [0.0, 0.06, 0.0]}}
        animation.channel(animation.sampler(quaternions_of(frames.gaze)), len(nodes), "rotation")
        nodes.append({"name": "lookAt"})
    extension = {
        "specVersion": VERSION,
        "humanoid": {"humanBones": bones},
        "expressions": {kind: named for kind, named in expressions.items() if named},
        **looks,
    }
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "scene": 0,
        "scenes": [{"nodes": roots}],
        "nodes": nodes,
        "extensions": {EXTENSION: extension},
        "extensionsUsed": [EXTENSION],
    }
    return encode_glb(document | animation.document(), store)


def _head_bones() -> list[Json]:
    """The nodes of the bones that hold a head up."""
    nodes: list[Json] = [{"name": bone, "translation": [0.0, height, 0.0]} for bone, height in SPINE]
    for place, node in enumerate(nodes[:-1], 1):
        node["children"] = [place]
    return nodes


def _bone_nodes(body: AnimatedBody) -> list[Json]:
    """The nodes of all bones, in the order of their motion."""
    names = body.motion.names
    nodes: list[Json] = [
        {"name": name, "translation": at} for name, at in zip(names, body.places.tolist(), strict=True)
    ]
    for place, name in enumerate(names):
        above = parent_among(name, names)
        if above:
            nodes[names.index(above)].setdefault("children", []).append(place)
    return nodes


def _move_bones(animation: _Animation, body: AnimatedBody) -> None:
    """Turns all bones that ever turn, and moves the hips."""
    motion = body.motion
    hips = motion.names.index(HIPS)
    for place, turns in enumerate(motion.turns.transpose(1, 0, 2)):
        if np.abs(turns[:, :3]).max() > 0.0:
            animation.channel(animation.sampler(_continuous(turns)), place, "rotation")
    animation.channel(animation.sampler(motion.hips * body.leg + body.places[hips]), hips, "translation")


def _continuous(turns: Values) -> Values:
    """Quaternions (n, 4) with signs that never jump, so that programs turn the short way."""
    flips = np.where((turns[1:] * turns[:-1]).sum(axis=1) < 0.0, -1.0, 1.0)
    return np.asarray(turns * np.concatenate([[1.0], np.cumprod(flips)])[:, None])


class _Animation:
    """An animation of glTF that grows: samplers on one list of times, each a view of the store."""

    def __init__(self, store: Store, times: Values, name: str) -> None:
        self._store = store
        self._name = name
        self._times = self._accessor(times.astype(np.float32), bounds=True)
        self._samplers: list[Json] = []
        self._channels: list[Json] = []

    def sampler(self, values: Values) -> int:
        """Adds a curve through values at the times, straight between them, and returns its place. values: a number, or
        a row, for each."""
        output = self._accessor(values.astype(np.float32))
        self._samplers.append({"input": self._times, "output": output, "interpolation": "LINEAR"})
        return len(self._samplers) - 1

    def channel(self, sampler: int, node: int, path: str) -> None:
        """Has a curve move a node. sampler: of the curve; node: its place; path: what of it."""
        self._channels.append({"sampler": sampler, "target": {"node": node, "path": path}})

    def document(self) -> Json:
        """The entry of the document; nothing where nothing moves."""
        if not self._channels:
            return {}
        return {"animations": [{"name": self._name, "samplers": self._samplers, "channels": self._channels}]}

    def _accessor(self, values: Floats, *, bounds: bool = False) -> int:
        kind = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}[1 if values.ndim == 1 else values.shape[1]]
        form: Json = {"componentType": FLOAT, "count": len(values), "type": kind}
        if bounds:
            form |= {"min": [float(values.min())], "max": [float(values.max())]}
        view = self._store.view(np.ascontiguousarray(values, "<f4").tobytes())
        return self._store.accessor({"bufferView": view, **form})
