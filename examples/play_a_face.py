"""Plays a face: calls two faces and an expression, one in the middle of the other, and prints what is on air.

For anybody who drives Omote from their own program (a game, an installation, a bot).
Run: python examples/play_a_face.py [FOLDER]        writes FOLDER/frames.csv
"""

import csv
import sys
from pathlib import Path

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

cast = omote.load_cast()
performer = omote.Performer(cast)

# The middle of the upper and of the lower lip: their distance says how far the mouth is open.
lips = next(line for line in cast.space.lines if line.name == "lips").loop
middle = lips[np.abs(cast.space.points[lips, 0]) < 1e-3]

FRAMES_PER_SECOND = 30
COMMANDS = {  # frame: what the operator does then
    0: lambda: performer.call_face("old", seconds=1.5),
    15: lambda: performer.call_expression("surprise", seconds=0.5),
    30: lambda: performer.call_face("child", seconds=1.0),  # the first call is still under way: nothing jumps
    60: performer.panic,  # neutral and still within a quarter of a second; the face stays
}

rows = []
for number in range(75):
    COMMANDS.get(number, lambda: None)()
    if 40 <= number < 55:
        performer.set_channel("jawOpen", (number - 40) / 20)  # channels are driven continuously, by a fader or tracker
    frame = performer.advance(1 / FRAMES_PER_SECOND)
    points = omote.evaluate(cast, frame)  # (V, 3) metres
    opening = 1000 * np.ptp(points[middle, 1])
    faces = " ".join(f"{name}={weight:.2f}" for name, weight in frame.faces.items())
    print(f"{frame.time:5.2f} s  {faces:40} mouth {opening:5.1f} mm {'#' * round(opening)}")
    rows.append([f"{frame.time:.4f}", faces, f"{opening:.3f}"])

with (out / "frames.csv").open("w", newline="") as file:
    csv.writer(file).writerows([["seconds", "faces", "mouth_mm"], *rows])
