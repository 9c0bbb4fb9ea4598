"""Makes faces from faces: a mix, the eyes of one with the jaw of another, a caricature. All of them play.

For artists and casting: a new person in one line, and how far it is from those it comes from.
Run: python examples/faces_from_faces.py [FOLDER]   writes FOLDER/NAME.obj for each new face
"""

import sys
from pathlib import Path

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

cast = omote.load_cast()
space = cast.space
faces = cast.faces

half = omote.Face("half", (faces["kaori"].positions + faces["old"].positions) / 2)
# Regions: brows, eyes, nose, cheeks, mouth, jaw, ears, skull; the rest from "old", smooth at the borders.
patched = omote.regional(space, "patched", {"eyes": faces["doll"], "jaw": faces["heavy"]}, rest=faces["old"])
louder = omote.caricature(space, faces["kaori"], 1.5)  # what makes her kaori, half as much again

for face in (half, patched, louder):
    smiling = omote.compound(space, face, cast.expressions["smile"])
    distance = {name: np.abs(face.positions - other.positions).mean() for name, other in faces.items()}
    nearest = min(distance, key=lambda name: distance[name])
    smile = 1000 * np.linalg.norm(smiling - face.positions, axis=1).max()
    print(f"{face.name:10} nearest to {nearest} ({1000 * distance[nearest]:.1f} mm away); smiles by {smile:.1f} mm")
    with (out / f"{face.name}.obj").open("w") as file:
        file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in smiling)
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in space.triangles + 1)
