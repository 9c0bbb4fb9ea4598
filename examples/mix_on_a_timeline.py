"""Plays a timeline (when, what) at a fixed frame rate and writes the moving vertices as a table.

For animators and researchers who want a performance as data: every run gives the same numbers.
Run: python examples/mix_on_a_timeline.py [FOLDER]  writes FOLDER/timeline.csv and FOLDER/last.obj
"""

import csv
import sys
from pathlib import Path
from typing import Any

import numpy as np

import omote

out = Path(sys.argv[1] if len(sys.argv) > 1 else "out")
out.mkdir(parents=True, exist_ok=True)

TIMELINE: list[tuple[float, str, list[Any], dict[str, Any]]] = [  # seconds, method of the performer, arguments
    (0.0, "call_face", ["kaori"], {"seconds": 0.0}),
    (0.2, "call_expression", ["smile"], {"seconds": 0.8}),
    (0.6, "call_face", ["dog"], {"seconds": 1.2, "easing": "gentle"}),
    (1.0, "set_channel", ["jawOpen", 0.4], {}),
    (1.4, "call_expression", ["angry"], {"seconds": 0.5, "easing": "sharp"}),
]
RATE = 25
SECONDS = 2.4

cast = omote.load_cast()
performer = omote.Performer(cast)
waiting = sorted(TIMELINE, key=lambda event: event[0])
now = 0.0

# Some vertices to follow: the front-most, the lowest and the left-most ones of the generic face.
generic = cast.space.points
tracked = {"nose": int(generic[:, 2].argmax()), "neck": int(generic[:, 1].argmin()), "ear": int(generic[:, 0].argmax())}

rows = []
for number in range(round(SECONDS * RATE) + 1):
    due = number / RATE
    while waiting and waiting[0][0] <= due:  # up to each event first, so that it happens at its own time
        at, method, arguments, options = waiting.pop(0)
        performer.advance(at - now)
        getattr(performer, method)(*arguments, **options)
        now = at
    frame = performer.advance(due - now)
    now = due
    points = omote.evaluate(cast, frame)
    rows += [[f"{due:.2f}", name, *np.round(points[row], 6)] for name, row in tracked.items()]

with (out / "timeline.csv").open("w", newline="") as file:
    csv.writer(file).writerows([["seconds", "vertex", "x", "y", "z"], *rows])
with (out / "last.obj").open("w") as file:
    file.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in points)
    file.writelines(f"f {a} {b} {c}\n" for a, b, c in cast.space.triangles + 1)
print(f"{len(rows)} rows of {len(tracked)} vertices in {out / 'timeline.csv'}, the last frame in {out / 'last.obj'}")
