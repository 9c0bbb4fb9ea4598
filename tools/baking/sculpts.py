"""The sculpted faces of the cast: src/omote/builtin/sculpts/*.toml, made into arrays beside the people's."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omote.builtin.binding import EYES, PARTS
from omote.interchange.formats.sculpt_toml import read_sculpt
from omote.model.known_names import GENERIC
from omote.model.sculpting.sculpt import Sculpt, sculpted
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from tools.baking.assemble import Arrays, Step, face_of
from tools.baking.heads.basemesh import Floats
from tools.baking.heads.people import PEOPLE
from tools.baking.package import BakeError

FOLDER = Path(__file__).resolve().parents[2] / "src" / "omote" / "builtin" / "sculpts"


def sculpt_paths(folder: Path = FOLDER) -> tuple[Path, ...]:
    """The sculpt files, by name."""
    return tuple(sorted(folder.glob("*.toml")))


def read_sculpts(folder: Path = FOLDER) -> tuple[Sculpt, ...]:
    """The sculpts in the order of their files' names; BakeError where one is none, or is not named as its file."""
    try:
        sculpts = tuple(read_sculpt(path) for path in sculpt_paths(folder))
    except ValueError as error:
        raise BakeError(str(error)) from error
    for path, sculpt in zip(sculpt_paths(folder), sculpts, strict=True):
        if sculpt.name != path.stem or sculpt.name in PEOPLE:
            raise BakeError(f"{path} holds a sculpt named {sculpt.name!r}; expected its file's name, and no person's")
    return sculpts


def sculpt_arrays(arrays: Arrays, space: ParameterSpace, sculpts: tuple[Sculpt, ...], step: Step) -> Arrays:
    """Positions (float32, metres) of skin and parts of every sculpt, the eyes where everybody has them.

    arrays: those of the people, from whom a sculpt may start.

    space: of the generic face; sculpts: in their order; step: is called with each name.
    """
    people = {name: face_of(arrays, name) for name in PEOPLE}
    found: Arrays = {}
    for sculpt in sculpts:
        face = sculpted(space, sculpt, people)
        shift = _eyes(people[GENERIC]) - _eyes(face)
        found[f"face/{face.name}"] = _round_to_nanometre(face.positions + shift)
        for part in PARTS:
            found[f"face/{face.name}/{part}"] = _round_to_nanometre(face.parts[part] + shift)
        step(face.name)
    return found


def _round_to_nanometre(points: Floats) -> NDArray[np.float32]:
    """To the nanometre: a solver's last bits, which depend on the machine, are gone, and the midline is at zero."""
    return np.asarray(np.round(points, 9) + 0.0, np.float32)


def _eyes(face: Face) -> Floats:
    """The middle of the box around both eyeballs, (3,) metres: what stays in place when faces change."""
    balls = np.concatenate([face.parts[eye] for eye in EYES]).astype(np.float64)
    return np.asarray((balls.min(axis=0) + balls.max(axis=0)) / 2)
