"""Takes an expression off one face and measures what it does to others, in millimetres.

For researchers: the same movement as a field that belongs to no face, a round trip, and a table of numbers.
Run: python examples/extract_and_measure.py [FOLDER]  writes FOLDER/measured.csv
"""

import csv
import sys
from pathlib import Path

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

cast = omote.load_cast()
space = cast.space
kaori = cast.faces["kaori"]

# A shape as a capture would give it: kaori with half a smile and a raised brow, (V, 3) metres. No name is left in it.
shape = omote.compound(space, kaori, cast.expressions["smile"], 0.5)
shape = shape + omote.compound(space, kaori, cast.expressions["browInnerUp"]) - kaori.positions

captured = omote.extract(space, kaori, shape - kaori.positions)
again = omote.compound(space, kaori, captured)
print(f"round trip on kaori: {1e6 * np.abs(again - shape).max():.3f} micrometres at most")

# The mouth's width and the brows' rise on every face, in millimetres.
lips = next(line for line in space.lines if line.name == "lips").loop
corners = lips[[space.points[lips, 0].argmin(), space.points[lips, 0].argmax()]]
raised = int(captured.dh.argmax())  # where the field rises most on S

rows = []
for name, face in cast.faces.items():
    worn = omote.compound(space, face, captured)
    width = [1000 * float(np.linalg.norm(np.diff(points[corners], axis=0))) for points in (face.positions, worn)]
    rise = 1000 * float(worn[raised, 1] - face.positions[raised, 1])
    rows.append([name, f"{width[0]:.2f}", f"{width[1]:.2f}", f"{rise:.2f}"])
    print(f"{name:8} mouth {width[0]:5.1f} -> {width[1]:5.1f} mm, brow rises {rise:5.2f} mm")

with (out / "measured.csv").open("w", newline="") as file:
    csv.writer(file).writerows([["face", "mouth_mm", "mouth_smiling_mm", "rise_mm"], *rows])
