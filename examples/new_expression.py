"""Makes an expression by dragging two control points of one face; three other faces wear it at once.

For artists who script, and for whoever wonders what "an expression belongs to no face" means.
Run: python examples/new_expression.py [FOLDER]     writes FOLDER/NAME_neutral.obj and FOLDER/NAME_smirk.obj
"""

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import omote
from omote.model.controls.default_net import default_net

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)


def write_obj(path: Path, points: NDArray[np.floating], triangles: NDArray[np.integer]) -> None:
    """Writes a mesh: points (V, 3) metres, triangles (F, 3)."""
    corners = [f"f {a} {b} {c}" for a, b, c in triangles + 1]
    path.write_text("\n".join([*(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points), *corners]) + "\n")


cast = omote.load_cast()
space = cast.space
kaori = cast.faces["kaori"]

# The editor's control points: places on S, the unrolled generic face.
rows = list(default_net(space))
net = omote.ControlNet.build(space, space.theta[rows], space.h[rows])
needles = net.points_on(kaori)  # where they stand on kaori, (n, 3) metres

# The left corner of the mouth 8 mm up and 4 mm out; the inner end of the left brow 5 mm up.
lips = next(line for line in space.lines if line.name == "lips").loop
corner = kaori.positions[lips[kaori.positions[lips, 0].argmax()]]
brow = corner * [0.6, 0, 1] + [0, 0.028, 0]
values = np.tile([0.0, 0.0, 1.0], (len(needles), 1))  # dtheta, dh, R: at rest
for place, move in ((corner, [0.004, 0.008, 0]), (brow, [0, 0.005, 0])):
    point = int(np.linalg.norm(needles - place, axis=1).argmin())
    values[point, :2] = net.drag(kaori, point, needles[point] + move)
smirk = net.expression(values)

for name in ("kaori", "old", "dog"):
    face = cast.faces[name]
    worn = omote.compound(space, face, smirk)
    moved = 1000 * np.linalg.norm(worn - face.positions, axis=1)
    print(f"{name:6} wears it: {np.count_nonzero(moved > 0.1)} vertices move, at most {moved.max():.1f} mm")
    write_obj(out / f"{name}_neutral.obj", face.positions, space.triangles)
    write_obj(out / f"{name}_smirk.obj", worn, space.triangles)
