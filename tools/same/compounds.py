"""Records what faces look like wearing expressions: every compound of the cast, and sums of many."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Literal

import numpy as np

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from omote.model.space.parameter_space import ParameterSpace, Transfer
from omote.model.transfer.compound import compound, compound_parts, turn_eyes
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame, Gaze, Head
from tools.same.recording import Numbers, Recording

SEED = 1993
FRAMES = 50
WEIGHTS: Mapping[Transfer, tuple[float, ...]] = {"smooth": (0.5, -0.3, 1.4), "paper": (0.25, 0.5, -0.3, 1.4)}
SPARSE: Mapping[Transfer, int] = {"smooth": 11, "paper": 5}
"""Of how many expressions one is worn at other weights too."""
POOL = 4, 24
"""Faces and expressions that the frames of one mode mix, so that compounds are computed once for many."""


@cache
def cast_under(transfer: Transfer) -> Cast:
    """The baked cast under a transfer rule."""
    cast = load_cast()
    return cast if cast.space.transfer == transfer else cast.under(transfer)


def record_face(recording: Recording, face: str, transfer: Transfer) -> None:
    """One face with every expression, its parts, and what each uses up of a sum; some at other weights."""
    cast = cast_under(transfer)
    wearer = cast.faces[face]
    for place, (name, expression) in enumerate(cast.expressions.items()):
        key = f"{face} {name}"
        skin = compound(cast.space, wearer, expression)
        recording.numbers(f"compounds {transfer}", key, skin)
        if place % 2 == 0 or transfer == "paper":
            parts = compound_parts(cast.space, wearer, expression)
            turned = turn_eyes(cast.space, parts, fit(cast.space, wearer).centres, expression.eyes)
            recording.numbers(f"compound parts {transfer}", key, *_in_order(parts), *_in_order(turned))
        if (place + len(face)) % SPARSE[transfer] == 0:
            for weight in WEIGHTS[transfer]:
                with recording.refusal(f"compounds at weights {transfer}: whether", f"{key} {weight:g}"):
                    moved = compound(cast.space, wearer, expression, weight)
                    recording.numbers(f"compounds at weights {transfer}", f"{key} {weight:g}", moved)
    if transfer == "smooth":
        _record_allowances(recording, cast, face)


def _record_allowances(recording: Recording, cast: Cast, face: str) -> None:
    known = compound_cache(cast)
    for place, name in enumerate(cast.expressions):
        if place % 4 == 0:
            recording.numbers("allowances", f"{face} {name}", known.allowance(face, name))


def record_fits(recording: Recording) -> None:
    """The space and every face fitted into it, under both rules."""
    for transfer in ("smooth", "paper"):
        space = cast_under(transfer).space
        _record_space(recording, f"baked {transfer}", space)
        for name, face in cast_under(transfer).faces.items():
            fitted = fit(space, face)
            sizes = [np.asarray(fitted.sizes[part]) for part in space.parts]
            parts = _in_order(fitted.parts)
            centres = _in_order(fitted.centres)
            skin = [fitted.positions, fitted.radii, fitted.scale]
            recording.numbers("faces fitted", f"{transfer} {name}", *skin, *sizes, *parts, *centres)


def _record_space(recording: Recording, key: str, space: ParameterSpace) -> None:
    arrays = [space.points, space.triangles, space.skin_triangles, space.membranes, space.theta, space.h]
    inner = [space.inner.vertices, space.inner.anchors, space.inner.weights]
    recording.numbers("spaces", key, *arrays, space.on_sheet, space.welded, *inner, *(x.loop for x in space.lines))
    for name, part in space.parts.items():
        recording.numbers("spaces", f"{key} {name}", part.points, part.triangles, part.anchors, part.weights)
    correctives = find_corrective_regions(space)
    if correctives is not None:
        crossings = [y for x in correctives.crossings for y in (x.vertices, x.weights, x.near, x.side, x.share)]
        own = [
            correctives.rows,
            correctives.triangles,
            correctives.lids,
            correctives.eye,
            correctives.followers,
            correctives.anchors,
        ]
        recording.numbers("corrective regions", key, *own, correctives.weights, *crossings)


def record_frames(recording: Recording, mode: Literal["bilinear", "exact"], transfer: Transfer) -> None:
    """Seeded random frames, skin and parts, correctives of sums included."""
    cast = cast_under(transfer)
    rng = np.random.default_rng([SEED, len(mode), len(transfer)])
    faces, expressions = pool(cast, rng)
    for place in range(FRAMES):
        frame = random_frame(faces, expressions, rng)
        skin = evaluate(cast, frame, mode)
        parts = evaluate_parts(cast, frame, mode)
        recording.numbers(f"frames {mode} {transfer}", f"{place:02d}", skin, *_in_order(parts))


def pool(cast: Cast, rng: np.random.Generator) -> tuple[list[str], list[str]]:
    """Names of faces and of expressions that frames are drawn from."""
    expressions = [name for name in cast.expressions if name != "neutral"]
    return rng.permutation(list(cast.faces))[: POOL[0]].tolist(), rng.permutation(expressions)[: POOL[1]].tolist()


def random_frame(faces: list[str], expressions: list[str], rng: np.random.Generator) -> Frame:
    """A mix as a show meets it; weights may leave 0..1 a little."""
    channels = rng.choice(expressions, size=int(rng.integers(0, 9)), replace=False).tolist()
    return Frame(
        faces=_weights(faces, int(rng.integers(1, 4)), rng),
        expressions=_weights(["neutral", *expressions], int(rng.integers(1, 5)), rng),
        channels={name: float(rng.uniform(-0.2, 1.0)) for name in channels},
        head=Head(*rng.uniform(-0.5, 0.5, 3).tolist()),
        gaze=Gaze(*rng.uniform(-0.4, 0.4, 2).tolist()),
    )


def _weights(names: list[str], count: int, rng: np.random.Generator) -> dict[str, float]:
    chosen = rng.choice(names, size=count, replace=False).tolist()
    share = rng.dirichlet(np.ones(count)) + 0.03 * rng.standard_normal(count)
    return dict(zip(chosen, (share / share.sum()).tolist(), strict=True))


def _in_order(arrays: Mapping[str, Numbers]) -> list[Numbers]:
    return [arrays[name] for name in sorted(arrays)]
