"""Figures of the smooth map: its stages one after the other, the closure of lids and lips, the correctives of sums."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.space.face import Face
from omote.model.space.face_fit import fit, generic_face
from omote.model.space.lid_lip_lines import Line
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer import pipeline
from omote.model.transfer.compound import compound, move_parts, turn_eyes
from omote.model.transfer.fold_repair import find_folds
from omote.model.transfer.paper_map import apply_paper_map, compile_expression, displace_generic
from omote.model.transfer.smooth_map import SmoothMap, prepare_smooth_map
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.blending.weighted_sum import weighted_sum
from omote.perform.frame import Frame
from tools.pictures.method.svg import AMBER, GREEN, GREY, INK, RED, VIOLET, Box, Chart, Figure
from tools.pictures.method.view import BALL, INNER, IRIS, SKIN, TEETH, TONGUE, Eye, Surface, marked, picture

Values = NDArray[np.float64]
Floats = NDArray[np.float32]
Mask = NDArray[np.bool_]
MATERIALS: Mapping[str, int] = {
    "eye_left": BALL, "eye_right": BALL, "teeth_upper": TEETH, "teeth_lower": TEETH, "tongue": TONGUE,
}  # fmt: skip


# ---- the stages of one compound

FAR_FACE = "dog"
LID = "eyeBlinkLeft"
MOUTH = "mouth-open"


@dataclass(frozen=True, eq=False)
class Stage:
    """What a stage leaves: its name, the whole skin (V, 3), and the sheet's triangles (t,) that are folded in it."""

    name: str
    skin: Values
    folded: Mask


def stages(cast: Cast, face: Face, expression: str) -> list[Stage]:
    """A compound by the paper's map, then as each stage of the pipeline leaves it, those that run twice "again"."""
    space = cast.space
    compiled = compile_expression(cast.space, cast.expressions[expression])
    state = pipeline.start(space, face, displace_generic(space, compiled), compiled.residual)
    geometry = state.smooth_map.geometry
    skin = apply_paper_map(space, fit(space, face), compiled).astype(np.float64)
    found = {"the paper's map": Stage("the paper's map", skin, find_folds(geometry, skin, state.source))}
    for stage in pipeline.STAGES:
        state = stage(state)
        inner = stage in (pipeline.fit_mouth_bag, pipeline.fit_socket_lining)
        whole = state if inner else pipeline.follow_inner_skin(pipeline.weld_seams(state))
        name = stage.__name__ + (" again" if stage.__name__ in found else "")
        found[name] = Stage(name, whole.skin.astype(np.float64), find_folds(geometry, state.sheet, state.source))
    return list(found.values())


def draw_stages(cast: Cast) -> Figure:
    """Lids and mouth of one far face after each stage of its compound, folded triangles in red."""
    figure = Figure(960, 474, f"The stages of a compound on the face {FAR_FACE}")
    for row, (expression, eye, kept) in enumerate(_ROWS):
        face = cast.faces[FAR_FACE]
        shown = [stage for stage in stages(cast, face, expression) if stage.name in kept]
        source = compound(cast.space, generic_face(cast.space), cast.expressions[expression]).astype(np.float64)
        top = 42.0 + 222 * row
        panels = [("the source, worn by the generic head", source, None), *((s.name, s.skin, s.folded) for s in shown)]
        for column, (name, skin, folded) in enumerate(panels):
            box = (12.0 + 157 * column, top, 151.0, 150.0)
            wearer = generic_face(cast.space) if folded is None else face
            _panel(figure, box, cast, wearer, expression, skin, folded, eye[folded is not None])
            _caption(figure, box, name, folded)
    figure.text(
        12,
        26,
        f"{LID} on {FAR_FACE}; red: triangles turned over here and not on the source, hidden ones too",
        colour=INK,
    )
    figure.text(12, 252, f"{MOUTH} on {FAR_FACE}", colour=INK)
    return figure


_SHEET = ("the paper's map", "transfer_detail", "close_lids_and_lips", "clear_eyeballs", "repair_folds again")
_ROWS = (
    (LID, (Eye((0.033, -0.003, 0.14), 0.04), Eye((0.035, -0.004, 0.12), 0.042)), _SHEET),
    (MOUTH, (Eye((0.0, -0.075, 0.15), 0.1), Eye((0.0, -0.075, 0.15), 0.13)),
     ("the paper's map", "transfer_detail", "close_lids_and_lips", "repair_folds", "fit_mouth_bag")),
)  # fmt: skip


def _panel(
    figure: Figure, box: Box, cast: Cast, face: Face, expression: str, skin: Values, folded: Mask | None, eye: Eye
) -> None:  # fmt: skip
    parts = _parts(cast, face, expression, skin)
    figure.rect(*box)
    figure.add(picture(eye, box, [_skin(cast.space, skin), *parts]))
    if folded is not None:
        marked(figure, eye, box, skin, cast.space.sheet_triangles[folded], RED)


def _skin(space: ParameterSpace, skin: Values) -> Surface:
    material = np.full(len(space.triangles), INNER)
    material[_rows_of_sheet(space)] = SKIN
    return Surface(skin, space.triangles, material)


def _rows_of_sheet(space: ParameterSpace) -> NDArray[np.intp]:
    place = {tuple(row): number for number, row in enumerate(space.triangles.tolist())}
    return np.array([place[tuple(row)] for row in space.skin_triangles.tolist()])


def _parts(cast: Cast, face: Face, expression: str, skin: Values) -> list[Surface]:
    space = cast.space
    fitted = fit(cast.space, face)
    worn = cast.expressions[expression]
    rest = compile_expression(space, worn).parts
    moved = move_parts(space, fitted, skin.astype(np.float32), rest)
    turned = turn_eyes(space, moved, fitted.centres, worn.eyes)
    return part_surfaces(space, turned)


def part_surfaces(space: ParameterSpace, parts: Mapping[str, Floats]) -> list[Surface]:
    """Eyeballs with their irises, teeth and tongue, as far as they are among the parts (n, 3) by name."""
    shown = [name for name in MATERIALS if name in parts]
    return [Surface(parts[name], space.parts[name].triangles, _of_part(space, name)) for name in shown]


def _of_part(space: ParameterSpace, name: str) -> NDArray[np.int64]:
    part = space.parts[name]
    middles = part.points[part.triangles].mean(axis=1) - part.points.mean(axis=0)
    ahead = middles[:, 2] / np.linalg.norm(middles, axis=1)
    kind = MATERIALS[name]
    return np.where((ahead > np.cos(_IRIS)) & (kind == BALL), IRIS, kind)


_IRIS = 0.52
"""Radians from the line of sight to the rim of a drawn iris."""


def _caption(figure: Figure, box: Box, name: str, folded: Mask | None) -> None:
    below = box[1] + box[3]
    for line, words in enumerate(_broken(name)):
        figure.text(box[0], below + 16 + 15 * line, words, colour=INK, size=12)
    if folded is not None:
        count = int(folded.sum())
        words = "1 fold" if count == 1 else f"{count} folds"
        figure.label(box[0] + box[2] - 6, box[1] + 18, words, colour=RED if count else GREEN, anchor="end")


def _broken(words: str, most: int = 22) -> list[str]:
    lines = [""]
    for word in words.split():
        if len(lines[-1]) + len(word) > most:
            lines.append("")
        lines[-1] = f"{lines[-1]} {word}".strip()
    return lines


# ---- how lids and lips close

FACES = ("baby", "old", "doll", "dog")
WEIGHTS = np.linspace(0.0, 1.0, 21)


def opening(line: Line, rest: NDArray[np.floating], now: NDArray[np.floating]) -> float:
    """How far lids are open: sum of e.g now over the sum of |g| at rest; lips: how much farther, over the width."""
    before = line.rungs(rest.astype(np.float64))
    after = line.rungs(now.astype(np.float64))
    length = np.linalg.norm(before, axis=1)
    if line.kind == "lids":
        return float((before / length[:, None] * after).sum() / length.sum())
    return float((after - before)[:, 1].mean() / np.ptp(rest[line.loop, 0]))


def closures(cast: Cast, face: str, expression: str, line: Line) -> dict[str, list[float]]:
    """The opening of a line at each of WEIGHTS, by the map that carried the unit; "source": the generic face's own."""
    space = cast.space
    generic = generic_face(cast.space).positions
    worn = cast.expressions[expression]
    rest = cast.faces[face].positions
    source = compound(space, generic_face(space), worn)
    old = cast.under("paper")
    ends = {
        "ours": compound(space, cast.faces[face], worn),
        "added deltas": rest + (source - generic),
        "the paper's map": compound(old.space, old.faces[face], old.expressions[expression]),
    }
    found = {name: [opening(line, rest, rest + w * (end - rest)) for w in WEIGHTS] for name, end in ends.items()}
    found["source"] = [opening(line, generic, compound(space, generic_face(space), worn, float(w))) for w in WEIGHTS]
    return found


_MAPS = {"source": INK, "ours": GREEN, "the paper's map": AMBER, "added deltas": RED}


def draw_closure(cast: Cast) -> Figure:
    """Lines of lids and lips with their rungs, and how far lids are open over the weight of a blink, on four faces."""
    figure = Figure(960, 520, "Lines of lids and lips, their rungs, and the opening over the weight")
    lines = {line.name: line for line in cast.space.lines}
    views = (("lid_left", "doll", Eye((0.036, 0.004, 0.13), 0.068)), ("lips", "doll", Eye((0.0, -0.062, 0.15), 0.055)))
    for number, (name, face, eye) in enumerate(views):
        box = (16.0, 44.0 + 232 * number, 290.0, 186.0)
        _rungs(figure, box, cast, cast.faces[face], lines[name], eye)
        figure.text(box[0], box[1] - 10, f"the line {name!r} and its 32 rungs on {face}", colour=INK)
    for number, face in enumerate(FACES):
        box = (358.0 + 312 * (number % 2), 44.0 + 232 * (number // 2), 262.0, 186.0)
        chart = Chart(figure, box, x=(0.0, 1.0), y=(-0.6, 1.05))
        chart.ticks_x((0.0, 0.25, 0.5, 0.75, 1.0))
        chart.ticks_y((-0.5, 0.0, 0.5, 1.0))
        found = closures(cast, face, "eyeBlinkLeft", lines["lid_left"])
        for way in ("added deltas", "the paper's map", "source", "ours"):
            chart.curve(WEIGHTS, found[way], _MAPS[way], width=5 if way == "source" else 2.2)
        chart.curve((0.0, 1.0), (0.0, 0.0), GREY, width=1.0, dash="4 3")
        figure.text(box[0], box[1] - 10, f"eyeBlinkLeft on {face}: opening over weight", colour=INK)
    figure.legend(16, 506, [("the source", INK), ("ours", GREEN), ("the paper's map", AMBER), ("added deltas", RED),
                            ("dashed: lids meet", GREY)])  # fmt: skip
    return figure


def _rungs(figure: Figure, box: Box, cast: Cast, face: Face, line: Line, eye: Eye) -> None:
    space = cast.space
    points = face.positions.astype(np.float64)
    figure.rect(*box)
    figure.add(picture(eye, box, [_skin(space, points), *part_surfaces(space, fit(space, face).parts)]))
    figure.line(eye.seen(points[line.loop], box)[:, :2], GREEN, width=2, closed=True)
    ends = np.einsum("rk,rkc->rc", np.maximum(line.weights, 0.0), points[line.vertices])
    for start, step in zip(ends, line.rungs(points), strict=True):
        figure.line(eye.seen(np.stack([start, start - step]), box)[:, :2], VIOLET, width=1.4)


# ---- correctives of sums

SUMMED = "old"
PAIR = ("eyeBlinkLeft", "eyeSquintLeft")


def summed(cast: Cast) -> list[Stage]:
    """Two units alone, their sum as added, the sum with its correctives; folded: only what neither unit folds alone."""
    face = cast.faces[SUMMED]
    compounds = compound_cache(cast)
    alone = [compounds.skin(SUMMED, unit) for unit in PAIR]
    added = weighted_sum([(1.0, alone[0]), (1.0, alone[1]), (-1.0, face.positions)])
    found = [*zip(PAIR, alone, strict=True), ("the sum as it is", added),
             ("the sum with its correctives", evaluate(cast, _BOTH))]  # fmt: skip
    ready = prepare_smooth_map(cast.space, face)
    known = _folded(ready, alone[0]) | _folded(ready, alone[1])
    return [Stage(name, skin.astype(np.float64), _folded(ready, skin) & ~known) for name, skin in found]


_BOTH = Frame({SUMMED: 1.0}, {"neutral": 1.0}, dict.fromkeys(PAIR, 1.0))


def draw_correctives(cast: Cast) -> Figure:
    """Two units that are whole each, their sum as added, and the sum with its correctives."""
    figure = Figure(960, 296, "Correctives: a blink and a squint at once")
    space = cast.space
    parts = part_surfaces(cast.space, evaluate_parts(cast, _BOTH))
    line = next(line for line in space.lines if line.name == "lid_left")
    rest = cast.faces[SUMMED].positions
    for number, panel in enumerate(summed(cast)):
        box = (16.0 + 234 * number, 44.0, 226.0, 180.0)
        figure.rect(*box)
        figure.add(picture(_AT_EYE, box, [_skin(space, panel.skin), *parts]))
        marked(figure, _AT_EYE, box, panel.skin, space.sheet_triangles[panel.folded], RED)
        figure.text(box[0], 32, panel.name, colour=INK)
        if number >= len(PAIR):
            count = int(panel.folded.sum())
            figure.text(box[0], 244, f"{count} folds that neither has alone", colour=RED if count else GREEN)
        crossed = 1000 * max(-least_rung(line, rest, panel.skin), 0.0)
        figure.text(box[0], 264, f"lids pass each other by {crossed:.1f} mm")
    figure.text(16, 286, f"On {SUMMED}, both at weight 1. Lids overlap in a blink alone; that much is allowed.")
    return figure


_AT_EYE = Eye((0.033, -0.004, 0.13), 0.045)


def _folded(ready: SmoothMap, skin: NDArray[np.floating]) -> Mask:
    return find_folds(ready.geometry, skin.astype(np.float64), ready.generic)


def least_rung(line: Line, rest: NDArray[np.floating], now: NDArray[np.floating]) -> float:
    """The worst rung: how far the upper lid is above the lower, along the rung at rest, metres."""
    before = line.rungs(rest.astype(np.float64))
    ways = before / np.linalg.norm(before, axis=1, keepdims=True)
    return float((ways * line.rungs(now.astype(np.float64))).sum(axis=1).min())
