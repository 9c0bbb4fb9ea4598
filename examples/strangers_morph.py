"""Two heads of different topologies: each wears the other's blendshape, and one morphs into the other through S.

For artists and researchers with heads of their own; these are faces of the cast, cut into other triangles.
Run: python examples/strangers_morph.py [FOLDER]   writes FOLDER/0.obj to FOLDER/4.obj, from the first to the second
"""

import sys
from pathlib import Path

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

cast = omote.load_cast()
space = cast.space


def make_stranger(name: str, expression: str, size: float, seed: int) -> omote.Scan:
    """A head as others have it: triangles split, rows shuffled, another unit, one blendshape."""
    face = cast.faces[name]
    draw = np.random.default_rng(seed)
    grin = omote.compound(space, face, cast.expressions[expression]) - face.positions
    count = space.vertex_count
    order = draw.permutation(space.vertex_count + len(space.triangles))
    middles = np.arange(len(space.triangles)) + count
    row = np.argsort(order)
    split = [np.column_stack([space.triangles[:, [k, (k + 1) % 3]], middles]) for k in range(3)]
    points, moves = (
        size * np.concatenate([each, each[space.triangles].mean(axis=1)])[order] for each in (face.positions, grin)
    )
    return omote.Scan(points, row[np.concatenate(split)], shapes={"grin": moves})


one = make_stranger("old", "mouthSmileLeft", 100.0, seed=1)
other = make_stranger("kaori", "jawOpen", 1000.0, seed=2)
fits = [omote.fit(space, each.positions, each.triangles, name=name) for each, name in ((one, "one"), (other, "other"))]
taken = [
    omote.take_expressions(space, fitted, scan).expressions["grin"]
    for fitted, scan in zip(fits, (one, other), strict=True)
]
for fitted, expression in zip(fits, reversed(taken), strict=True):  # each wears the other's
    moved = omote.compound(space, fitted.face, expression) - fitted.face.positions
    print(f"{fitted.face.name} wears the other's by {1000 * np.linalg.norm(moved, axis=1).max():.1f} mm")

for step, share in enumerate(np.linspace(0.0, 1.0, 5)):
    rest = (1 - share) * fits[0].face.positions + share * fits[1].face.positions
    face = omote.Face("between", rest)
    worn = rest + sum(
        weight * (omote.compound(space, face, each) - rest)
        for weight, each in zip((1 - share, share), taken, strict=True)
    )
    with (out / f"{step}.obj").open("w") as file:
        file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in worn)
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in space.triangles + 1)
