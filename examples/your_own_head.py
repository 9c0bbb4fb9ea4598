"""Takes any head as the generic face: an OBJ file in, a parameter space, an expression and a second face that wears it.

For labs and studios with a mesh of their own; nothing of the built-in cast is used.
Run: python examples/your_own_head.py [FOLDER]      writes FOLDER/head.obj, FOLDER/smile.obj, FOLDER/long_smile.obj

The head here is made of rings so that no file is needed; put your own at FOLDER/head.obj (y up, +z ahead, metres).
"""

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import omote
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.wavefront_reader import read_wavefront

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)


def write_obj(path: Path, points: NDArray[np.floating], triangles: NDArray[np.integer]) -> None:
    """Writes a mesh: points (V, 3) metres, triangles (F, 3)."""
    corners = [f"f {a} {b} {c}" for a, b, c in triangles + 1]
    path.write_text("\n".join([*(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points), *corners]) + "\n")


def egg(rings: int = 32, columns: int = 48) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A head of rings with a nose, open at the neck: points (V, 3) metres, triangles (F, 3)."""
    h, theta = np.meshgrid(np.linspace(-0.13, 0.12, rings), np.linspace(-np.pi, np.pi, columns, endpoint=False))
    r = 0.085 * np.sqrt(1 - (h / 0.125) ** 2 * np.where(h > 0, 1, 0.6))
    r = r * (1 + 0.1 * np.cos(theta)) + 0.02 * np.exp(-((theta / 0.25) ** 2) - ((h + 0.01) / 0.02) ** 2)
    points = np.stack([r * np.sin(theta), h, r * np.cos(theta)], axis=-1).reshape(-1, 3)
    column, row = np.meshgrid(np.arange(columns), np.arange(rings - 1), indexing="ij")
    a, b = (column * rings + row).ravel(), ((column + 1) % columns * rings + row).ravel()
    top = np.arange(columns) * rings + rings - 1
    crown = np.stack([top, np.roll(top, -1), np.full(columns, len(points))], axis=1)
    sides = [np.stack([a, b, b + 1], axis=1), np.stack([a, b + 1, a + 1], axis=1)]
    return np.concatenate([points, [[0, 0.125, 0]]]), np.concatenate([*sides, crown])


head = out / "head.obj"
if not head.exists():
    write_obj(head, *egg())

mesh = read_wavefront(head.read_bytes(), Companions())
points, triangles = mesh.positions, np.asarray(mesh.triangles)

space = omote.ParameterSpace.build(points, triangles)  # axis, skin sheet and openings are found here
print(f"{space.vertex_count} vertices, {len(space.skin_triangles)} of {len(triangles)} triangles on the sheet")

# Both corners of a mouth, on S: a smile raises them and pulls them out.
theta, h = np.meshgrid(np.linspace(-np.pi, np.pi, 16, endpoint=False), np.quantile(space.h, [0.1, 0.3, 0.5, 0.7, 0.9]))
net = omote.ControlNet.build(space, theta.ravel(), h.ravel())
values = np.tile([0.0, 0.0, 1.0], (theta.size, 1))
corners = (np.abs(np.abs(theta) - np.pi / 8) < 1e-6) & (h == h[1, 0])
values[corners.ravel()] = [[np.sign(t) * 0.05, 0.008, 1.02] for t in theta[corners]]
smile = net.expression(values)

own = omote.Face("own", points)
long = omote.Face("long", points * [0.9, 1.2, 1.0])  # any other shape of the same mesh
for name, face in (("smile", own), ("long_smile", long)):
    worn = omote.compound(space, face, smile)
    write_obj(out / f"{name}.obj", worn, triangles)
    print(f"{name}: at most {1000 * np.linalg.norm(worn - face.positions, axis=1).max():.1f} mm")
