"""Real heads that nobody here made, for tests marked `data`; they are never committed."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"

Head = tuple[NDArray[np.float64], NDArray[np.int64]]


def ict_facekit() -> Head:
    """The ICT-FaceKit head in metres: points (26719, 3) and triangles."""
    return _read(DATA / "ict_facekit" / "generic_neutral_mesh.obj", 0.01)


def perry_smith() -> Head:
    """The Lee Perry-Smith scan, scaled to about a head's size: points (V, 3) and triangles."""
    return _read(DATA / "lee_perry_smith_ccby" / "LeePerrySmith.obj", 0.03)


def _read(path: Path, scale: float) -> Head:
    if not path.exists():
        pytest.skip(f"{path.name} is not here; it belongs into ../shared/data")
    points = []
    triangles = []
    for line in path.read_text().splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "v":
            points.append([float(value) for value in rest.split()[:3]])
        if kind == "f":
            polygon = [int(corner.split("/")[0]) - 1 for corner in rest.split()]
            triangles += [[polygon[0], *polygon[i : i + 2]] for i in range(1, len(polygon) - 1)]
    return np.array(points) * scale, np.array(triangles)
