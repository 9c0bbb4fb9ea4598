"""The Lee Perry-Smith scan, where it is at hand: shut eyes, no eyeballs, torn at its seams; landmarks by hand."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

FILE = Path(__file__).resolve().parents[3] / "shared" / "data" / "lee_perry_smith_ccby" / "LeePerrySmith.obj"
# Clicked in a picture from the front, x and y in the scan's unit; the surface says how deep.
CLICKS: Mapping[str, tuple[float, float]] = {
    "right_eye_outer": (-0.98, 1.62), "right_eye_inner": (-0.41, 1.71), "left_eye_inner": (0.22, 1.70),
    "left_eye_outer": (0.81, 1.64), "nose_tip": (-0.09, 1.13), "mouth_right": (-0.49, 0.39), "mouth_left": (0.37, 0.42),
}  # fmt: skip
# What is so near a click, in the scan's unit, may be what was clicked: the foremost of it was.
NEAR = 0.06


def read_scan() -> tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Points (n, 3) in the scan's unit, triangles (t, 3)."""
    points = []
    triangles = []
    for line in FILE.read_text(encoding="utf-8").splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "v":
            points.append([float(value) for value in rest.split()[:3]])
        if kind == "f":
            polygon = [int(corner.split("/")[0]) - 1 for corner in rest.split()]
            triangles += [[polygon[0], *polygon[i : i + 2]] for i in range(1, len(polygon) - 1)]
    return np.array(points), np.array(triangles, np.int32)


def clicks(points: NDArray[np.float64], /) -> dict[str, NDArray[np.float64]]:
    """The seven landmarks: of the points near each click, the foremost."""
    found = {}
    for name, place in CLICKS.items():
        near = points[np.hypot(*(points[:, :2] - place).T) < NEAR]
        found[name] = near[near[:, 2].argmax()]
    return found
