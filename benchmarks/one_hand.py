"""A performer's take, played again through what one hand and a pad of the mouth can say.

Each take of Live Link Face (beside the repository) is cut in halves. On the first, how far each control moves each of
its units is fitted; on every sixth frame of the second, the controls are set so that the face is nearest to the
performer's. Blinks and gaze are given: automatic motion plays them. Beside the best place of all controls it is played
as a hand goes there: nine tenths of a step in .15 s, lag removed. Then the engine plays both on faces of the cast, and
the distance of visible skin from the take played by all its units is told, of the worst vertex, for all of the face and
by region; explained is the share of square millimetres on the generic head, all frames together.

The rows of ../shared/design/hand.md, section 2, are printed beside ours where it has them.

`python -m benchmarks.one_hand [--takes alex_rom_3,apfel,S07-001] [--every 6] [--faces generic,dog]`. Without the data
it says so and ends with 0.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.progress import track
from rich.table import Table

import omote
from benchmarks.performance_take import TAKE, Take, read_take
from omote.geometry.mesh import normals
from omote.model.cast import Cast
from omote.model.known_names import GENERIC, NEUTRAL, PlayRegion
from omote.model.transfer.compound import compound
from omote.perform.blending.evaluate import evaluate
from omote.perform.blending.region_masks import play_masks
from omote.perform.frame import Frame
from omote.perform.layers.follower import follow_number, rate_of
from omote.perform.scene.cast_pads import cast_pads

Values = NDArray[np.float64]
GIVEN = ("eyeBlink", "eyeLook")
"""Beginnings of the names of units that automatic motion plays."""
FACING = 0.2
"""Of a vertex normal's share towards the audience: skin that is seen."""
HAND_SECONDS = 0.15
"""In which a hand goes nine tenths of a step (hand.md, section 2)."""
GRID = 17
ROUNDS = 6
SWEEPS = 24
RATE = 60.0
SIDES = ("Left", "Right")


def both(*names: str) -> tuple[str, ...]:
    """Units of the left and of the right."""
    return tuple(f"{name}{side}" for name in names for side in SIDES)


JAW = (("jawOpen",),)
CORNERS = (both("mouthSmile"), both("mouthFrown"))
BROWS = (("browInnerUp", *both("browOuterUp")), both("browDown"))
ROUND = (("mouthPucker", "mouthFunnel"), both("mouthStretch"))
PRESSED = ((*both("mouthPress"), "mouthRollLower", "mouthRollUpper"), both("mouthUpperUp", "mouthLowerDown"))
WAYS: Mapping[str, tuple[tuple[tuple[tuple[str, ...], ...], ...], bool, str]] = {
    "jaw": ((JAW,), False, ".592, 4.1/15/18"),
    "jaw, corners, brows": ((JAW, CORNERS, BROWS), False, ".826, 3.6/9.5/15"),
    "five of one hand": ((JAW, CORNERS, BROWS, ROUND, PRESSED), False, ".954, 2.1/4.6/7.4"),
    "jaw and brows, pad of the mouth": ((JAW, BROWS), True, ".949, 1.4/5.8/13"),
    "five of one hand, pad of the mouth": ((JAW, CORNERS, BROWS, ROUND, PRESSED), True, ""),
}
"""What plays: controls, each with the units of its way up and of its way down; whether a pad does; hand.md's row."""


@dataclass(frozen=True, eq=False)
class Linear:
    """What names do to the generic face near rest: gram (n, n), square metres of seen skin."""

    names: tuple[str, ...]
    gram: Values

    def row(self, weights: Mapping[str, float]) -> Values:
        """Weights by name as a vector (n,)."""
        return np.array([weights.get(name, 0.0) for name in self.names])


def seen_skin(cast: Cast) -> NDArray[np.bool_]:
    """Which vertices (V,) of the generic face an audience sees."""
    points = cast.faces[GENERIC].positions.astype(np.float64)
    facing = normals(points, cast.space.skin_triangles)[:, 2]
    return np.asarray(cast.space.on_sheet & (facing > FACING))


def find_linear(cast: Cast, names: Sequence[str]) -> Linear:
    """What the names do, each alone at full weight."""
    face = cast.faces[GENERIC]
    seen = seen_skin(cast)
    rest = face.positions.astype(np.float64)
    moves = [(compound(cast.space, face, cast.expressions[name], 1.0) - rest)[seen].ravel() for name in names]
    table = np.array(moves)
    return Linear(tuple(names), table @ table.T)


@dataclass(frozen=True, eq=False)
class Ways:
    """Halves of controls as rows (h, n), and mixtures of the pad at its places (p, n); p = 1 where there is no pad."""

    halves: Values
    mixes: Values

    def solve(self, linear: Linear, wanted: Values) -> tuple[Values, int]:
        """The weights (n,) nearest to those wanted (n,), each half 0..1: coordinate descent at all places at once.
        Returns the halves (h,) and the place's number."""
        gram = linear.gram
        left = wanted - self.mixes
        towards = left @ gram @ self.halves.T
        among = self.halves @ gram @ self.halves.T
        at = np.zeros_like(towards)
        for _ in range(SWEEPS):
            for half in range(at.shape[1]):
                rest = towards[:, half] - at @ among[:, half] + at[:, half] * among[half, half]
                at[:, half] = np.clip(rest / max(among[half, half], 1e-12), 0.0, 1.0)
        cost = np.einsum("pn,nm,pm->p", left, gram, left) - 2.0 * (towards * at).sum(axis=1)
        cost += np.einsum("ph,hg,pg->p", at, among, at)
        best = int(cost.argmin())
        return at[best], best


def halves_of(
    linear: Linear, controls: Sequence[Sequence[Sequence[str]]], gains: Mapping[str, float]
) -> tuple[Values, list[tuple[str, ...]]]:
    """The halves of all controls as rows, and the units of each. gains: of units, 1 without one."""
    units = [tuple(half) for control in controls for half in control]
    rows = [
        linear.row({unit: gains.get(f"{number}/{unit}", 1.0) for unit in half}) for number, half in enumerate(units)
    ]
    return np.array(rows), units


def fit_gains(
    linear: Linear, controls: Sequence[Sequence[Sequence[str]]], mixes: Values, take: Values
) -> dict[str, float]:
    """How far each control moves each unit, fitted on frames (f, n) by turns with the controls."""
    gains: dict[str, float] = {}
    for _ in range(ROUNDS):
        halves, units = halves_of(linear, controls, gains)
        ways = Ways(halves, mixes)
        solved = [ways.solve(linear, wanted) for wanted in take]
        at = np.array([each[0] for each in solved])
        mixed = np.array([mixes[each[1]] for each in solved])
        columns = [(number, unit) for number, half in enumerate(units) for unit in half]
        rows = np.array([linear.names.index(unit) for _, unit in columns])
        control = at[:, [number for number, _ in columns]]
        left = (take - mixed) @ linear.gram[:, rows]
        among = (control.T @ control) * linear.gram[np.ix_(rows, rows)]
        towards = (control * left).sum(axis=0)
        fitted = np.array([gains.get(f"{number}/{unit}", 1.0) for number, unit in columns])
        for _ in range(SWEEPS):
            for place in range(len(fitted)):
                rest = towards[place] - among[place] @ fitted + among[place, place] * fitted[place]
                fitted[place] = min(1.5, max(0.0, rest / max(among[place, place], 1e-9)))
        gains = {f"{number}/{unit}": float(gain) for (number, unit), gain in zip(columns, fitted, strict=True)}
    return gains


def mixes_of(linear: Linear, pad: omote.Pad | None) -> tuple[Values, list[tuple[float, float]]]:
    """The mixtures of a pad of two dimensions at places of a grid, as rows, and the places."""
    if pad is None:
        return np.zeros((1, len(linear.names))), [(0.0, 0.0)]
    ticks = np.linspace(-1.0, 1.0, GRID)
    places = [(float(x), float(y)) for x in ticks for y in ticks]
    return np.array([linear.row(pad.mix_at(place)) for place in places]), places


def by_hand(values: Values, times: Values) -> Values:
    """Controls (f, c) as a hand gets there, its lag removed: two poles forwards, and as many frames earlier as fit
    best. times: of the frames, seconds."""
    rate = rate_of(HAND_SECONDS)
    played = np.empty_like(values)
    for column in range(values.shape[1]):
        first = second = float(values[0, column])
        for frame, goal in enumerate(values[:, column].tolist()):
            dt = float(times[frame] - times[frame - 1]) if frame else 0.0
            first, second = follow_number(first, second, goal, rate, max(dt, 0.0))
            played[frame, column] = second
    lag = min(range(16), key=lambda by: float(((played[by:] - values[: len(values) - by]) ** 2).mean()))
    return np.concatenate([played[lag:], np.repeat(played[-1:], lag, axis=0)])


def tell_distance(distance: Values) -> str:
    """Median, 95 % and most over frames, millimetres."""
    return "/".join(f"{1e3 * np.quantile(distance, part):.1f}" for part in (0.5, 0.95, 1.0))


@dataclass(frozen=True, eq=False)
class Measure:
    """What is asked of every way: cast, seen skin, faces to wear it."""

    cast: Cast
    seen: NDArray[np.bool_]
    faces: tuple[str, ...]

    def play(self, face: str, channels: Mapping[str, float], mouth: Mapping[str, float] | None = None) -> Values:
        """Skin (V, 3) of a face. mouth: the mix of the pad in its region."""
        regions: dict[PlayRegion, Mapping[str, float]] = {} if mouth is None else {"mouth": mouth}
        worn = {name: weight for name, weight in channels.items() if weight}
        return evaluate(self.cast, Frame({face: 1.0}, {NEUTRAL: 1.0}, worn, regions=regions)).astype(np.float64)

    def regions(self) -> dict[str, NDArray[np.bool_]]:
        """The seen vertices of each play region."""
        masks = play_masks(self.cast.space)
        return {region: self.seen & (mask.skin[:, 0] > 0.5) for region, mask in masks.items()}


def find_pad(cast: Cast) -> omote.Pad:
    """The pad of the mouth that comes with the cast."""
    return next(pad for pad in cast_pads(cast).values() if pad.part == "mouth")


def measure_take(console: Console, cast: Cast, name: str, every: int, faces: tuple[str, ...]) -> None:
    """Plays a take in all ways and prints its table."""
    take = read_take(TAKE.parent / f"{name}.csv", 0)
    kept = [unit for unit in take.units if not unit.startswith(GIVEN) and unit in cast.expressions]
    given = [unit for unit in take.units if unit.startswith(GIVEN) and unit in cast.expressions]
    pad = find_pad(cast)
    names = list(dict.fromkeys([*kept, *(look for each in pad.looks for look in each.mix), *all_units()]))
    linear = find_linear(cast, names)
    column = {unit: number for number, unit in enumerate(take.units)}
    weights = np.array([linear.row({unit: row[column[unit]] for unit in kept}) for row in take.weights])
    half = len(weights) // 2
    learned = weights[:half:every]
    tested = np.arange(half, len(weights), every)
    measure = Measure(cast, seen_skin(cast), faces)
    regions = measure.regions()
    table = Table(title=f"{name}: {len(tested)} frames; worst vertex, median/95 %/most, mm", title_justify="left")
    for title in ("through", "explained", "hand.md", *faces, *(f"{faces[0]}: {region}" for region in regions)):
        table.add_column(title, justify="right")
    for title, (controls, with_pad, theirs) in track(WAYS.items(), name, console=Console(stderr=True)):
        rows, places = mixes_of(linear, pad if with_pad else None)
        gains = fit_gains(linear, controls, rows, learned)
        halves, units = halves_of(linear, controls, gains)
        ways = Ways(halves, rows)
        solved = [ways.solve(linear, wanted) for wanted in weights[half:]]
        best = np.array([[*at, *places[place]] for at, place in solved])
        for how, played in (("", best), (", by hand", by_hand(best, take.times[half:]))):
            told = play_frames(
                measure, take, given, kept, tested, half, played, units, gains, pad if with_pad else None
            )
            distances = (tell_distance(told[name]) for name in (*faces, *regions))
            table.add_row(title + how, f"{told['explained']:.3f}", "" if how else theirs, *distances)
    console.print(table)


def all_units() -> list[str]:
    """The units of all controls."""
    return [unit for controls, _, _ in WAYS.values() for control in controls for half in control for unit in half]


def play_frames(
    measure: Measure, take: Take, given: Sequence[str], kept: Sequence[str], tested: NDArray[np.intp], half: int,
    played: Values, units: Sequence[Sequence[str]], gains: Mapping[str, float], pad: omote.Pad | None,
) -> dict[str, Values]:  # fmt: skip
    """How far faces are from the take in the frames tested: of the worst vertex by face and by region of the first, and
    the share explained. played: controls and place of each frame of the second half."""
    column = {unit: number for number, unit in enumerate(take.units)}
    distance: dict[str, list[float]] = {name: [] for name in (*measure.faces, *measure.regions())}
    off = there = 0.0
    for frame in tested.tolist():
        row = take.weights[frame]
        automatic = {unit: float(row[column[unit]]) for unit in given}
        performed = automatic | {unit: float(row[column[unit]]) for unit in kept}
        at = played[frame - half]
        again = dict(automatic)
        for number, names in enumerate(units):
            for unit in names:
                again[unit] = again.get(unit, 0.0) + float(at[number]) * gains.get(f"{number}/{unit}", 1.0)
        mouth = None if pad is None else pad.mix_at((float(at[-2]), float(at[-1])))
        for face in measure.faces:
            meant = measure.play(face, performed)
            apart = np.linalg.norm(measure.play(face, again, mouth) - meant, axis=1)
            distance[face].append(float(apart[measure.seen].max()))
            if face == measure.faces[0]:
                rest = measure.play(face, automatic)
                off += float((apart[measure.seen] ** 2).sum())
                there += float((np.linalg.norm(meant - rest, axis=1)[measure.seen] ** 2).sum())
                for region, mask in measure.regions().items():
                    distance[region].append(float(apart[mask].max()))
    return {name: np.array(values) for name, values in distance.items()} | {"explained": np.array(1.0 - off / there)}


def main() -> int:
    """Plays, measures and prints."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--takes", default="alex_rom_3,apfel,S07-001")
    parser.add_argument("--every", type=int, default=6)
    parser.add_argument("--faces", default="generic,dog")
    asked = parser.parse_args()
    console = Console(width=220)
    if not TAKE.exists():
        console.print(f"no takes at {TAKE.parent}: nothing to play")
        return 0
    cast = omote.load_cast()
    for name in asked.takes.split(","):
        measure_take(console, cast, Path(name).stem, asked.every, tuple(asked.faces.split(",")))
    return 0


if __name__ == "__main__":
    sys.exit(main())
