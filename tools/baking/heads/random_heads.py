"""Identity modes: the directions in which heads of people differ most, from random people of the package's targets.

Principal components (Blanz and Vetter 1999, "A morphable model for the synthesis of 3D faces"), skin and parts
together, of heads that were brought to one place and size before. Fits of scans begin with them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.builtin.binding import PARTS
from omote.model.known_names import GENERIC
from omote.model.space.similarity import fit_similarity
from tools.baking.heads.basemesh import BaseMesh, Floats, read_target
from tools.baking.heads.head import Head
from tools.baking.heads.person import Build, Person, target_weights
from tools.baking.package import Package

PEOPLE = 900
MODES = 110
SEED = 14
FOLDERS = ("head", "ears", "neck", "cheek", "chin", "forehead", "eyebrows", "eyes", "nose", "mouth", "asym")
LEFT_OUT = "breast|trunk"
RACES = ("african", "asian", "caucasian")
# Standard deviations of a target's weight, of what one side has more, and of the crooked shapes.
SHAPE = 0.35
SIDE = 0.08
CROOKED = 0.15
_SIDES = re.compile(r"/([lr])-|-([lr])$")


def identity_modes(
    package: Package, base: BaseMesh, head: Head, baked: Mapping[str, NDArray[Any]]
) -> dict[str, NDArray[Any]]:
    """The arrays of identity_modes.npz: modes (m, V + parts, 3), metres of one standard deviation, the most first; and
    the mean (V + parts, 3).

    baked: the arrays of cast.npz, on whose generic face the modes are put.

    package: the published files; base, head: the base mesh and the head cut from it.
    """
    rows = np.concatenate([head.skin.vertices, *(head.parts[part].vertices for part in PARTS)])
    generic = np.concatenate([baked[f"face/{GENERIC}"], *(baked[f"face/{GENERIC}/{part}"] for part in PARTS)])
    moves = _align(base.points[rows], _draw_people(package, len(base.points), rows), len(head.skin.vertices))
    middle = moves.mean(axis=0)
    modes = _principal(moves - middle, MODES)
    unit = head.unit_metres
    # Half precision: 0.005 mm where a mode moves by 10, far less than what is fitted after the modes.
    return {"mean": (generic + unit * middle).astype(np.float32), "modes": (unit * modes).astype(np.float16)}


def _draw_people(package: Package, count: int, rows: NDArray[np.integer]) -> Floats:
    """Displacements (PEOPLE, n, 3) of rows of the base mesh, in its unit."""
    draw = np.random.default_rng(SEED)
    names = _names(package)
    recipes = [_recipe(draw, names) for _ in range(PEOPLE)]
    used = sorted({name for recipe in recipes for name in recipe})
    weights = np.array([[recipe.get(name, 0.0) for name in used] for recipe in recipes])
    targets = [read_target(package.text(f"mpfb2/targets/{name}.target.gz"), count)[rows] for name in used]
    result: Floats = np.einsum("pt,tnc->pnc", weights, np.array(targets), optimize=True)
    return result


def _names(package: Package) -> list[str]:
    names = package.names("mpfb2/targets/", ".target.gz")
    return [name for name in names if name.split("/")[0] in FOLDERS and not re.search(LEFT_OUT, name)]


def _recipe(draw: np.random.Generator, names: Sequence[str]) -> dict[str, float]:
    """Weights of targets: sliders anywhere, shapes as common as they are slight, both sides nearly alike."""
    shares = draw.dirichlet(np.full(len(RACES), 0.7))
    build = Build(
        gender=draw.uniform(), age=draw.uniform(0.1, 1.0), muscle=draw.uniform(), weight=draw.uniform(),
        race=dict(zip(RACES, shares.tolist(), strict=True)),
    )  # fmt: skip
    weights = target_weights(Person(look={}, build=build))
    both = dict[str, float]()
    for name in names:
        spread = CROOKED if name.startswith("asym/") else SHAPE
        alike = name if name.startswith("asym/") else _SIDES.sub("/", name)
        amount = both.setdefault(alike, draw.normal(0.0, spread))
        weights[name] = max(amount + (draw.normal(0.0, SIDE) if alike != name else 0.0), 0.0)
    return weights


def _align(points: Floats, moves: Floats, skin: int) -> Floats:
    """The displacements (p, n, 3) after each person was brought over the points (n, 3), by their first rows' skin."""
    weights = np.ones(skin)
    aligned = np.empty(moves.shape)
    for person, move in enumerate(moves):
        aligned[person] = fit_similarity(points[:skin] + move[:skin], points[:skin], weights)(points + move) - points
    return aligned


def _principal(moves: Floats, count: int) -> Floats:
    """The first principal components (count, n, 3), each as long as its standard deviation; the largest value of each
    is positive."""
    flat = moves.reshape(len(moves), -1)
    _, left = np.linalg.eigh(flat @ flat.T / len(flat))
    kept = left[:, ::-1][:, :count] / np.sqrt(len(flat))
    modes = kept.T @ flat
    largest = np.abs(modes).argmax(axis=1)
    result: Floats = (modes * np.sign(modes[np.arange(count), largest])[:, None]).reshape(count, *moves.shape[1:])
    return result
