"""The skeleton of a figure from the package's rig of 163 bones: those of the face are its head, toes are one."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from omote.model.body.figure_space import BONES_OF_A_ROW
from omote.model.body.skeleton import ARM, LEG, SIDES, TRUNK, Skeleton
from tools.baking.bodies.figure_cut import FigureCut
from tools.baking.heads.basemesh import BaseMesh, Floats, Ints
from tools.baking.package import Package

RIG = "mpfb2/rigs/standard/rig.default.json"
WEIGHTS = "mpfb2/rigs/standard/weights.default.json"
HANGING = {"clavicle": "spine01", "pelvis": "root"}
"""On what of the trunk a limb's first bone hangs."""
KNUCKLES = {1: "wrist", 2: "metacarpal1", 3: "metacarpal2", 4: "metacarpal3", 5: "metacarpal4"}
"""On what each finger hangs, the thumb first."""
TOE = "toe"
BREAST = ("breast", "spine02")
"""A bone that no pose turns, and whose weights go to the other."""


@dataclass(frozen=True)
class Rig:
    """The skeleton; rows of the base mesh whose mean is where a bone begins and where it ends, by its place; weights:
    (rows of the base mesh, J)."""

    skeleton: Skeleton
    heads: tuple[Ints, ...]
    tails: tuple[Ints, ...]
    weights: Floats

    def joints(self, points: Floats) -> Floats:
        """Where bones begin, (J, 3); points: of a base mesh, in any unit."""
        return np.stack([points[rows].mean(axis=0) for rows in self.heads])

    def ends(self, points: Floats) -> Floats:
        """Where they end, (J, 3)."""
        return np.stack([points[rows].mean(axis=0) for rows in self.tails])


def figure_bones() -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names of the bones, parents first, and the name of each one's parent, "" for the first."""
    pairs = [(name, TRUNK[place - 1] if place else "") for place, name in enumerate(TRUNK)]
    for side in SIDES:
        for limb in (ARM, LEG):
            above = (HANGING[limb[0]], *(f"{name}.{side}" for name in limb[:-1]))
            pairs += [(f"{name}.{side}", parent) for name, parent in zip(limb, above, strict=True)]
        pairs += [(f"metacarpal{number}.{side}", f"wrist.{side}") for number in range(1, 5)]
        for finger, knuckle in KNUCKLES.items():
            row = [f"finger{finger}-{joint}.{side}" for joint in (1, 2, 3)]
            pairs += list(zip(row, (f"{knuckle}.{side}", *row[:-1]), strict=True))
    return tuple(name for name, _ in pairs), tuple(parent for _, parent in pairs)


def read_rig(package: Package, base: BaseMesh) -> Rig:
    """The package's rig with the bones of a figure.

    package: the published files; base: the base mesh, whose cubes are joints.
    """
    published: Mapping[str, Any] = json.loads(package.text(RIG))
    names, parents = figure_bones()
    places = {name: place for place, name in enumerate(names)}
    skeleton = Skeleton(names, np.array([places.get(parent, -1) for parent in parents], np.int32))
    heads, tails = zip(*(_ends(published, name, base) for name in names), strict=True)
    table: Mapping[str, list[list[float]]] = json.loads(package.text(WEIGHTS))["weights"]
    weights = np.zeros((len(base.points), len(names)))
    for bone, rows in table.items():
        place = places[_merged(published, bone, places)]
        for row, weight in rows:
            weights[int(row), place] += weight
    return Rig(skeleton, heads, tails, weights)


def _ends(published: Mapping[str, Any], name: str, base: BaseMesh) -> tuple[Ints, Ints]:
    """The rows where a bone begins and ends; toes begin where all of them do and end where the middle one ends."""
    if not name.startswith("toes."):
        return end_rows(published[name]["head"], base), end_rows(published[name]["tail"], base)
    side = name[-1]
    first = [end_rows(published[f"toe{toe}-1.{side}"]["head"], base) for toe in range(1, 6)]
    return np.concatenate(first), end_rows(published[f"toe3-3.{side}"]["tail"], base)


def end_rows(end: Mapping[str, Any], base: BaseMesh) -> Ints:
    """The rows of the base mesh whose mean is where a published bone begins or ends. end: of the rig's file."""
    if end["strategy"] == "CUBE":
        return np.unique(base.groups[end["cube_name"]].corners)
    rows = end["vertex_indices"] if end["strategy"] == "MEAN" else [end["vertex_index"]]
    return np.array(rows, np.int32)


def _merged(published: Mapping[str, Any], bone: str, places: Mapping[str, int]) -> str:
    """The figure's bone that takes a published one's weights: itself, or the nearest above it."""
    if bone.startswith(TOE):
        return f"toes.{bone[-1]}"
    if bone.startswith(BREAST[0]):
        return BREAST[1]
    while bone not in places:
        bone = published[bone]["parent"]
    return bone


def row_weights(rig: Rig, cut: FigureCut) -> tuple[Ints, Floats]:
    """The bones (V + B, 8) of each row of the figure and their weights, the largest eight made to sum to one."""
    table = rig.weights[cut.vertices]
    bones = np.argsort(-table, axis=1, kind="stable")[:, :BONES_OF_A_ROW]
    weights = np.take_along_axis(table, bones, axis=1)
    return bones.astype(np.int32), weights / weights.sum(axis=1, keepdims=True)
