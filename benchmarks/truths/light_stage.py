"""ICT-FaceKit's identities: another topology, where it is at hand beside the repository.

One set of displacements belongs to all of its identities, so added deltas are the truth by its making; what another map
differs by is all its own: it tells where a loss lies, not who is right.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from benchmarks.truths.pair import Pair
from omote.model.space.face import Face
from omote.model.space.face_fit import generic_face
from omote.model.space.parameter_space import ParameterSpace

Values = NDArray[np.float64]

FOLDER = Path(__file__).resolve().parents[3] / "shared" / "data" / "ict_facekit"
# The first so many vertices are skin, with the linings of mouth and eyes; the file counts in centimetres.
SKIN = 14062
CENTIMETRE = 0.01
MOUTH = slice(11248, 13294)
EYES = {"lid_right": slice(13294, 13678), "lid_left": slice(13678, 14062)}
# How strongly identities are drawn; expressions that move less, metres, are left out.
STRENGTH = 0.9
LEAST = 5e-4


def light_stage_pairs(units: int, seed: int, people: int = 3) -> Iterator[Pair]:
    """The neutral head to so many identities drawn with a seed, and the first of these to the others."""
    points, triangles = _read_skin((FOLDER / "generic_neutral_mesh.obj").read_text(encoding="utf-8"))
    space = _name_lines(ParameterSpace.build(points, triangles))
    moves = _read_moves(units)
    modes = np.load(FOLDER / "identities_i16.npz")
    draw = np.random.default_rng(seed)
    faces = []
    for number in range(people):
        weights = STRENGTH * CENTIMETRE * float(modes["scale"]) * draw.normal(size=len(modes["q"]))
        shape = points + np.tensordot(weights, modes["q"][:, :SKIN].astype(np.float64), 1)
        faces.append(Face(f"identity {number}", shape.astype(np.float32)))
    neutral = generic_face(space)
    for source, others in ((neutral, faces), (faces[0], faces[1:])):
        for face in others:
            yield Pair(f"{source.name} to {face.name}", space, source, face, moves, moves, {})


def _read_moves(units: int) -> dict[str, Values]:
    data = np.load(FOLDER / "expressions_f32.npz")
    moves = {
        str(name): CENTIMETRE * delta[:SKIN].astype(np.float64)
        for name, delta in zip(data["names"], data["delta"], strict=True)
    }
    names = [name for name, move in moves.items() if np.abs(move).max() > LEAST]
    return {name: moves[name] for name in (names[i] for i in np.linspace(0, len(names) - 1, units).astype(int))}


def _read_skin(text: str) -> tuple[Values, NDArray[np.int32]]:
    rows = [line.split() for line in text.splitlines()]
    points = CENTIMETRE * np.array([row[1:4] for row in rows if row[:1] == ["v"]][:SKIN], dtype=np.float64)
    polygons = [[int(corner.split("/")[0]) - 1 for corner in row[1:]] for row in rows if row[:1] == ["f"]]
    fans = [[each[0], each[i], each[i + 1]] for each in polygons if max(each) < SKIN for i in range(1, len(each) - 1)]
    return points, np.array(fans, dtype=np.int32)


def _name_lines(space: ParameterSpace) -> ParameterSpace:
    lining = space.points[MOUTH]
    for name, rows in EYES.items():
        space = space.with_line(name, "lids", space.points[rows].mean(axis=0))
    return space.with_line("lips", "lips", lining[lining[:, 2].argmax()])
