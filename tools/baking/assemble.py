"""Assembles the arrays of cast.npz from the published files (their list: omote.builtin.castfile)."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.builtin.binding import PARTS, PartMesh, head_space
from omote.builtin.castfile import FORMAT, SKIN
from omote.model.controls.mirror import mirror_rows
from omote.model.extraction.extract import extract
from omote.model.folding import LIDS, most_compression
from omote.model.known_names import GENERIC, NEUTRAL
from omote.model.sculpting.sculpt import Sculpt
from omote.model.sculpting.socket_depth import fit_lining_at_rest
from omote.model.space.complexion import PALE, Complexion
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.mouth_at_rest import close_behind_lips, fit_mouth_at_rest
from tools.baking.expressions import (
    ARKIT,
    COMPLEXIONS,
    MAKEHUMAN,
    OMOTE,
    PERFORMED,
    PUPILS,
    SPRING_EARS,
    SPRINGS,
    ear_turns,
    head_turn,
    region,
)
from tools.baking.heads.basemesh import BaseMesh, Floats
from tools.baking.heads.head import Head, Piece
from tools.baking.heads.mouth_bag import carry_bag, keep_bag_inside
from tools.baking.heads.moves import Move
from tools.baking.heads.neck import level_throat
from tools.baking.heads.people import PEOPLE
from tools.baking.heads.person import person_points
from tools.baking.labels import label
from tools.baking.package import Package
from tools.baking.skin.raster import openness

Arrays = dict[str, NDArray[Any]]
Step = Callable[[str], None]

# A face is symmetric whose vertices are so near, metres, to their mirror images.
_ACROSS = np.array([-1.0, 1.0, 1.0])
_SYMMETRIC = 2e-6


def face_arrays(package: Package, base: BaseMesh, head: Head, step: Step) -> Arrays:
    """Positions (float32, metres) of skin and parts of every person.

    package: the published files; base, head: the base mesh and the head cut from it; step: is called with each name.
    """
    arrays: Arrays = {}
    generic = head.metres(base.points)[head.skin.vertices]
    for name, person in PEOPLE.items():
        points = head.metres(person_points(person, package, base, head))
        skin = level_throat(points[head.skin.vertices], generic, head.skin.triangles)
        arrays[f"face/{name}"] = skin.astype(np.float32)
        for part in PARTS:
            arrays[f"face/{name}/{part}"] = points[head.parts[part].vertices].astype(np.float32)
        step(name)
    return arrays


def mesh_arrays(head: Head, layout: Floats) -> Arrays:
    """Triangles, and the meshes as they are drawn: the skin on its own layout, the parts on the published one.

    head: the cut head; layout (k, 2): of the skin.
    """
    arrays: Arrays = {"triangles": head.skin.triangles}
    arrays.update(_split_at_seams(SKIN, head.skin, layout))
    for part in PARTS:
        piece = head.parts[part]
        arrays[f"part/{part}"] = piece.triangles
        arrays.update(_split_at_seams(part, piece, piece.uvs * [1.0, -1.0] + [0.0, 1.0]))
    return arrays


def _split_at_seams(name: str, piece: Piece, uvs: Floats) -> Arrays:
    """Every pair of vertex and texture coordinate once; uvs (k, 2), (0, 0) the upper left corner."""
    pairs = np.stack([piece.triangles.ravel(), piece.uv_corners.ravel()], axis=1)
    drawn, corners = np.unique(pairs, axis=0, return_inverse=True)
    return {
        f"drawn/{name}/source": drawn[:, 0].astype(np.int32),
        f"drawn/{name}/uv": uvs[drawn[:, 1]].astype(np.float32),
        f"drawn/{name}/triangles": corners.reshape(-1, 3).astype(np.int32),
    }


def openness_arrays(arrays: Arrays) -> Arrays:
    """How much of the sky the drawn vertices of the generic face see, 0 to 255, all meshes in each other's way."""
    points = {SKIN: arrays[f"face/{GENERIC}"], **{part: arrays[f"face/{GENERIC}/{part}"] for part in PARTS}}
    starts = dict(zip(points, np.cumsum([0, *map(len, points.values())]), strict=False))
    own = {SKIN: arrays["triangles"], **{part: arrays[f"part/{part}"] for part in PARTS}}
    triangles = np.concatenate([own[mesh] + start for mesh, start in starts.items()])
    sky = np.rint(255 * openness(np.concatenate([*points.values()]).astype(np.float64), triangles)).astype(np.uint8)
    return {f"drawn/{mesh}/openness": sky[start + arrays[f"drawn/{mesh}/source"]] for mesh, start in starts.items()}


def face_of(arrays: Arrays, name: str) -> Face:
    """A face of the arrays.

    arrays: of cast.npz; name: whose.
    """
    return Face(name, arrays[f"face/{name}"], {part: arrays[f"face/{name}/{part}"] for part in PARTS})


def space_of(arrays: Arrays) -> ParameterSpace:
    """The parameter space of the generic face, its parts bound; the arrays hold its meshes and `jaw`, and `sheet` once
    it is known."""
    generic = face_of(arrays, GENERIC)
    parts = {part: PartMesh(generic.parts[part].astype(np.float64), arrays[f"part/{part}"]) for part in PARTS}
    return head_space(
        generic.positions.astype(np.float64), arrays["triangles"], parts, arrays["jaw"], arrays.get("sheet")
    )


def fit_mouths(arrays: Arrays, space: ParameterSpace, names: Iterable[str]) -> None:
    """Closes the lips of faces, in place, and puts their mouth bags to their gums and behind their skin, and behind it
    the lining of their eye sockets.

    arrays: of cast.npz, changed; space: of the generic face; names: whose faces.
    """
    across = mirror_rows(space)
    for name in names:
        parts = {part: arrays[f"face/{name}/{part}"] for part in PARTS}
        before = arrays[f"face/{name}"]
        placed = fit_lining_at_rest(space, fit_mouth_at_rest(space, before, parts))
        arrays[f"face/{name}"] = _symmetric_as(before, placed, across)


def fit_generic_mouth(arrays: Arrays) -> None:
    """Does so with the generic face, whose sheet is S and stays: the arrays' `sheet` from then on, for behind closed
    lips it would be found without the edges of the lower one."""
    open_lips = space_of(arrays)
    arrays["sheet"] = open_lips.skin_triangles
    fit_mouths(arrays, open_lips, [GENERIC])
    space = space_of(arrays)
    name = f"face/{GENERIC}"  # which skin belongs to which lip is measured on this one
    arrays[name] = _symmetric_as(arrays[name], close_behind_lips(space, arrays[name]), mirror_rows(space))


def _symmetric_as(before: NDArray[Any], placed: NDArray[np.floating], across: NDArray[np.integer]) -> NDArray[Any]:
    """The placed points (V, 3), symmetric if those before were: gums are met on one side a little more than across."""
    found = placed.astype(np.float64)
    if np.abs(before - before[across] * _ACROSS).max() < _SYMMETRIC:
        found = 0.5 * (found + found[across] * _ACROSS)
    return np.asarray(np.round(found, 9) + 0.0, np.float32)  # no machine's last bits


def field_arrays(arrays: Arrays, space: ParameterSpace, moves: Mapping[str, Move], step: Step) -> Arrays:
    """Every expression as a field on S, taken from the generic face by the paper's map; first the one at rest, last
    those that move no skin of people.

    arrays: of cast.npz so far; space: of the generic face; moves: by expression; step: is called with each name.
    """
    generic = face_of(arrays, GENERIC)
    expressions = [_at_rest(space)]
    for name, move in moves.items():
        skin = keep_bag_inside(space, carry_bag(space, move.skin, move.parts["teeth_lower"]))
        taken = extract(space, generic, skin, parts=move.parts)
        blood = Complexion(*COMPLEXIONS.get(name, PALE))
        turned = replace(taken, ears=ear_turns(name), head=head_turn(name))
        expressions.append(replace(turned, pupil=PUPILS.get(name, 0.0), complexion=blood))
        step(name)
    for name, pupil in {**OMOTE, **dict.fromkeys(SPRING_EARS, 0.0)}.items():
        expressions.append(replace(_at_rest(space), pupil=pupil, ears=ear_turns(name), head=head_turn(name)))
        step(name)
    pressing = [own for name, own in zip(moves, expressions[1:], strict=False) if _presses(name)]
    return {**_stack(expressions, space), "folding": most_compression(space, pressing)}


def _presses(name: str) -> bool:
    """Whether the folds of an expression count: lids that only blink or follow the gaze press skin that is not meant,
    and springs shake it."""
    return name not in LIDS and name not in SPRINGS


def _at_rest(space: ParameterSpace) -> Expression:
    count = space.vertex_count
    return Expression(np.zeros(count), np.zeros(count), np.ones(count), np.zeros((len(space.inner.vertices), 3)))


def _stack(expressions: list[Expression], space: ParameterSpace) -> Arrays:
    """The fields as float32: their rounding is below a millionth of a millimetre."""
    stacks: dict[str, list[NDArray[Any]]] = {
        "dtheta": [expression.dtheta for expression in expressions],
        "dh": [expression.dh for expression in expressions],
        "swell": [expression.ratio - 1.0 for expression in expressions],
        "residual": [expression.residual for expression in expressions],
        "eyes": [expression.eyes for expression in expressions],
        "ears": [expression.ears for expression in expressions],
        "head": [expression.head for expression in expressions],
        "pupil": [np.array(expression.pupil) for expression in expressions],
        "complexion": [np.array(expression.complexion) for expression in expressions],
    }
    for part in PARTS:
        still = np.zeros_like(space.parts[part].points)
        stacks[f"rest/{part}"] = [expression.parts.get(part, still) for expression in expressions]
    return {name: np.stack(stack).astype(np.float32) for name, stack in stacks.items()}


def about(moves: Mapping[str, Move], sculpts: Sequence[Sculpt]) -> Arrays:
    """Names, looks and titles as JSON, and the format's number.

    moves: by expression, in their order; sculpts: in theirs.
    """
    faces = {name: dict(person.look) for name, person in PEOPLE.items()}
    faces |= {sculpt.name: asdict(sculpt.look) for sculpt in sculpts}
    rows = [{"name": NEUTRAL, "label": label(NEUTRAL), "kind": "neutral", "region": "whole"}]
    names = (*moves, *OMOTE, *SPRING_EARS)
    rows += [{"name": name, "label": label(name), "kind": _kind(name), "region": region(name)} for name in names]
    answers = {name: person.gains for name, person in PEOPLE.items()} | {each.name: each.gains for each in sculpts}
    gains = {name: [asdict(gain) for gain in own] for name, own in answers.items() if own}
    text = json.dumps({"faces": faces, "gains": gains, "expressions": rows}, indent=1)
    return {"format": np.array(FORMAT), "about": np.frombuffer(text.encode(), dtype=np.uint8)}


def _kind(name: str) -> str:
    named = {"performed": PERFORMED, "arkit": ARKIT, "makehuman": MAKEHUMAN, "omote": OMOTE, "spring": SPRINGS}
    return next(kind for kind, names in named.items() if name in names)
