"""Random people of ICT-FaceKit, where it is at hand beside the repository: other topology, true correspondence."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from benchmarks.truths.light_stage import CENTIMETRE, FOLDER, SKIN

Values = NDArray[np.float64]

STRENGTH = 0.9
SCLERA = {"eye_left": slice(21451, 22221), "eye_right": slice(23021, 23791)}
# Of its 68 landmarks, those that people are asked to click.
CLICKS: Mapping[str, int] = {
    "left_eye_outer": 45, "left_eye_inner": 42, "right_eye_inner": 39, "right_eye_outer": 36, "nose_tip": 30,
    "mouth_left": 54, "mouth_right": 48,
}  # fmt: skip


@dataclass(frozen=True, eq=False)
class Model:
    """The mean head: points (n, 3) metres, triangles (t, 3) of everything, modes (100, n, 3) in metres of one standard
    deviation, landmarks (68,) as rows."""

    points: Values
    triangles: NDArray[np.int32]
    modes: Values
    landmarks: NDArray[np.int64]

    @property
    def skin(self) -> NDArray[np.int32]:
        """The triangles of skin, with the linings of mouth and eyes."""
        return self.triangles[(self.triangles < SKIN).all(axis=1)]

    def draw(self, seed: tuple[int, int], /) -> Values:
        """The points (n, 3) of somebody."""
        weights = STRENGTH * np.random.default_rng(seed).normal(size=len(self.modes))
        result: Values = self.points + np.tensordot(weights, self.modes, 1)
        return result

    def clicks(self, person: Values, /) -> dict[str, Values]:
        """Somebody's seven landmarks."""
        return {name: person[self.landmarks[row]] for name, row in CLICKS.items()}


def at_hand() -> bool:
    """Whether the model is there."""
    return FOLDER.is_dir()


@cache
def read_model() -> Model:
    """The model, read once."""
    rows = [line.split() for line in (FOLDER / "generic_neutral_mesh.obj").read_text(encoding="utf-8").splitlines()]
    points = CENTIMETRE * np.array([row[1:4] for row in rows if row[:1] == ["v"]], np.float64)
    polygons = [[int(corner.split("/")[0]) - 1 for corner in row[1:]] for row in rows if row[:1] == ["f"]]
    fans = [[each[0], each[i], each[i + 1]] for each in polygons for i in range(1, len(each) - 1)]
    modes = np.load(FOLDER / "identities_i16.npz")
    named = json.loads((FOLDER / "vertex_indices.json").read_text(encoding="utf-8"))
    return Model(
        points, np.array(fans, np.int32), CENTIMETRE * float(modes["scale"]) * modes["q"].astype(np.float64),
        np.array(named["idx_to_landmark_verts"]),
    )  # fmt: skip


@cache
def read_shapes() -> dict[str, Values]:
    """Its blendshapes of the face by name, displacements (n, 3) in metres; without those of pupils alone."""
    data = np.load(FOLDER / "expressions_f32.npz")
    shapes = {
        str(name): CENTIMETRE * each.astype(np.float64) for name, each in zip(data["names"], data["delta"], strict=True)
    }
    return {name: each for name, each in shapes.items() if not name.startswith("Pupil")}
