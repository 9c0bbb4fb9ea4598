"""VRM Animations of strangers: their own rests, scales and curves; what is none is rejected at once."""

from __future__ import annotations

import json
import time
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from omote.interchange.clips.humanoid_motion import HumanoidMotion, parent_among
from omote.interchange.clips.vrma_reader import EXTENSION, vrma_motion
from omote.interchange.formats.glb_writer import Store, encode_glb
from tests.interchange.clips.humanoids import HIPS_METRES, LEG_METRES, MIXAMO, degrees_apart, moving, offset_of

Json = dict[str, Any]


def vrma_of(motion: HumanoidMotion, *, scale: float = 1.0, seed: int | None = None, kind: str = "LINEAR") -> bytes:
    """A file of a motion whose bones have their own axes at rest (random by seed) under a root that is scaled."""
    store = Store()
    random = np.random.default_rng(seed)
    own = {
        bone: Rotation.identity() if seed is None else Rotation.random(rng=random) for bone in motion.names
    }  # fmt: skip
    worlds = {bone: turn * own[bone] for bone, turn in motion.worlds().items()}
    nodes: list[Json] = [{"name": "root", "scale": [scale] * 3, "children": [1]}]
    channels: list[Json] = []
    samplers: list[Json] = []

    def accessor(values: np.ndarray, of: str) -> int:
        view = store.view(np.ascontiguousarray(values, "<f4").tobytes())
        return store.accessor({"bufferView": view, "componentType": 5126, "count": len(values), "type": of})

    times = accessor(motion.times, "SCALAR")

    def move(node: int, path: str, values: np.ndarray) -> None:
        if kind == "CUBICSPLINE":  # slopes of a straight way
            slopes = np.gradient(values, motion.times, axis=0)
            values = np.stack([slopes, values, slopes], axis=1).reshape(-1, values.shape[1])
        samplers.append({"input": times, "output": accessor(values, f"VEC{values.shape[1]}"), "interpolation": kind})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})

    for place, bone in enumerate(motion.names, 1):
        above = parent_among(bone, motion.names)
        turned = own[above].inv() if above else Rotation.identity()
        at = turned.apply(offset_of(bone) if above else [0.0, HIPS_METRES, 0.0]) / scale
        nodes.append({"name": bone, "translation": at.tolist(), "rotation": (turned * own[bone]).as_quat().tolist()})
        if above:
            nodes[1 + motion.names.index(above)].setdefault("children", []).append(place)
        turns = (worlds[above].inv() * worlds[bone] if above else worlds[bone]).as_quat()
        signs = np.cumprod([1.0, *np.sign((turns[1:] * turns[:-1]).sum(axis=1))])
        move(place, "rotation", turns * signs[:, None])
    move(1, "translation", (motion.hips * LEG_METRES + [0.0, HIPS_METRES, 0.0]) / scale)
    extra = {"happy": "preset", "Wink": "custom"}
    expressions: dict[str, Json] = {"preset": {}, "custom": {}}
    for name, group in extra.items():
        expressions[group][name] = {"node": len(nodes)}
        ramp = np.linspace(0.0, 1.0, len(motion.times))[:, None] * [1.0, 0.0, 0.0]
        move(len(nodes), "translation", ramp)
        nodes.append({"name": name})
    bones = {bone: {"node": place} for place, bone in enumerate(motion.names, 1)}
    looks = {"node": len(nodes)}
    yaw = np.linspace(-0.4, 0.4, len(motion.times))
    move(len(nodes), "rotation", Rotation.from_euler("Y", yaw[:, None]).as_quat())
    nodes.append({"name": "eyes"})
    extension = {
        "specVersion": "1.0", "humanoid": {"humanBones": bones}, "expressions": expressions, "lookAt": looks,
    }  # fmt: skip
    document = {
        "asset": {"version": "2.0"}, "nodes": nodes,
        "extensionsUsed": [EXTENSION], "extensions": {EXTENSION: extension},
        "animations": [{"channels": channels, "samplers": samplers}],
    }  # fmt: skip
    return encode_glb(document, store)


@pytest.mark.parametrize("kind", ["LINEAR", "CUBICSPLINE"])
@pytest.mark.parametrize(("scale", "seed"), [(1.0, None), (0.01, 3)])
def test_any_rest_any_scale_and_any_curve_come_in_as_they_moved(scale: float, seed: int | None, kind: str) -> None:
    motion = moving(tuple(MIXAMO), frames=25)
    read = vrma_motion(vrma_of(motion, scale=scale, seed=seed, kind=kind))
    assert len(read.times) == 25
    assert max(degrees_apart(motion, read).values()) < 0.05  # float32
    assert np.abs(read.hips - motion.hips).max() < 1e-4
    assert read.weights["happy"] == pytest.approx(np.linspace(0.0, 1.0, 25), abs=1e-6)
    assert set(read.weights) == {"happy", "Wink"}
    assert read.gaze is not None
    assert read.gaze[:, 0] == pytest.approx(np.linspace(-0.4, 0.4, 25), abs=1e-5)


def changed(**entries: object) -> bytes:
    """A sound file with other entries in its document."""
    data = vrma_of(moving(tuple(MIXAMO), frames=3))
    length = int.from_bytes(data[12:16], "little")
    document = json.loads(data[20 : 20 + length]) | entries
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = data[20 + length :]
    return (
        data[:8]
        + (20 + len(text) + len(body)).to_bytes(4, "little")
        + len(text).to_bytes(4, "little")
        + data[16:20]
        + text
        + body
    )


def hostile() -> dict[str, bytes]:
    curve = {"channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}}]}
    accessor = {"componentType": 5126, "type": "SCALAR", "bufferView": 0}
    bones = {"humanoid": {"humanBones": {"hips": {"node": 999999}}}}
    return {
        "no GLB": b"HIERARCHY",
        "is no VRM Animation": changed(extensions={}),
        "has no animation": changed(animations=[]),
        "names no hips": changed(extensions={EXTENSION: {"humanoid": {"humanBones": {"head": {"node": 1}}}}}),
        "speaks of node 999999": changed(extensions={EXTENSION: bones}),
        "is not valid": changed(extensions={EXTENSION: {"humanoid": []}}),
        "expected 2000 at most": changed(nodes=[{}] * 3000),
        "more than": changed(
            animations=[curve | {"samplers": [{"input": 0, "output": 1}]}],
            accessors=[accessor | {"count": 2**30}, accessor | {"count": 2**30, "type": "VEC4"}],
        ),
        "hangs under two": changed(nodes=[{"children": [1]}, {"children": [2]}, {"children": [1]}, {}] * 10),
        "nothing moves": changed(animations=[{"channels": [], "samplers": []}]),
    }


@pytest.mark.parametrize("said", hostile())
def test_what_is_no_animation_is_rejected_at_once(said: str) -> None:
    begun = time.process_time()
    with pytest.raises(ValueError, match=said):
        vrma_motion(hostile()[said])
    assert time.process_time() - begun < 1.0


def test_hips_that_stand_among_nodes_in_a_circle_are_rejected() -> None:
    nodes = [{"children": [1]}, {"children": [0]}]
    with pytest.raises(ValueError, match="export"):
        vrma_motion(changed(nodes=nodes, extensions={EXTENSION: {"humanoid": {"humanBones": {"hips": {"node": 1}}}}}))
