"""A clip that moves all that formats have, and what three.js reads of a file."""

from __future__ import annotations

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from omote.interchange.clips.clip_frames import ClipFrames, sample_clip
from omote.model.cast import Cast
from omote.perform.clips.clip import Clip, Lane
from omote.perform.clips.cut_clip import record
from omote.perform.performer import Performer
from tools.node import find_node

WEB = Path(__file__).parents[3] / "web"
READER = (Path(__file__).parent / "read_with_three.mjs").read_text()


def moving_clip(cast: Cast, seconds: float = 0.5) -> Clip:
    """A call, a channel, a head and eyes that turn all ways."""
    performer = Performer(cast)
    performer.set_motion(0.5)
    performer.call_expression("smile", seconds=0.4)
    performer.set_channel("jawOpen", 0.4)
    performer.set_head(0.3, 0.2, -0.2)
    performer.gesture("shake")
    performer.gesture("nod")
    performer.look_at("direction", yaw=-0.3, pitch=0.1)
    return Clip([Lane(record(performer, cast, seconds=seconds))])


def frames_of(cast: Cast) -> ClipFrames:
    """Its frames."""
    return sample_clip(moving_clip(cast))


def read_with_three(path: Path) -> Any:
    """What the loaders of three.js and three-vrm read of a file."""
    where = _node_path()
    command = [shutil.which("node", path=where) or "node", "--input-type=module", "-e", READER, str(path)]
    done = subprocess.run(command, cwd=WEB, env={"PATH": where}, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


@cache
def _node_path() -> str:
    path = find_node()
    assert path is not None
    return path


def turn(quaternion: np.ndarray[Any, np.dtype[np.float64]]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The matrix (3, 3) of a rotation (x, y, z, w)."""
    x, y, z, w = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def angles_between(one: Any, other: Any) -> float:
    """The largest angle, degrees, between rotations (n, 4) and others."""
    cosines = [
        (np.trace(turn(a).T @ turn(b)) - 1.0) / 2.0
        for a, b in zip(np.reshape(one, (-1, 4)), np.reshape(other, (-1, 4)), strict=True)
    ]
    return float(np.degrees(np.arccos(np.clip(min(cosines), -1.0, 1.0))))
