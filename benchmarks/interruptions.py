"""Ten thousand random interruptions, ours beside the paper's plain freeze on the same log, on the built-in cast.

Half of the calls go to faces and half to expressions; each lasts 0.5-4 s (log-uniform), and the next one of its axis
comes at a random moment inside it. Both engines are the show's own axis with the same easing; the freeze forgets the
velocity that a call takes over (paper, eq. 4-7). Looked at 240 times a second:

* No vertex moves further in a step than its peak speed allows. The allowance knows nothing of the samples: each call's
  polynomials give the largest rate of its weights within the step, half the sum of absolute rates (the rates sum to
  nothing) times the largest distance between two compounds of that vertex. All vertices are measured in the steps
  around each interruption, every 16th vertex in all steps.
* The largest change of velocity from one step to the next, over all vertices and all steps. Most steps need no vertex:
  the same inequality bounds their change from the weights alone, and steps are looked at from the largest bound down
  until the bound falls below what was found (branch and bound; the maximum is exact). The freeze's own is searched
  only around the interruptions, so it is at most too small, which is the strict side.
* Weights sum to one and stay in range, in every step.

Draws docs/pictures/interruptions.svg: the largest speed of any vertex over nine seconds of the log.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # read when NumPy is loaded

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

import omote
from omote.model.cast import Cast
from omote.perform.axis import Axis, advanced, called, weights
from omote.perform.blending.compound_cache import CompoundCache
from omote.perform.easing import DEFAULT_EASING, EASINGS, bump_rate

SEED = 1993
COUNT = 10_000
RATE = 240
SHORTEST = 0.5
LONGEST = 4.0
BAR_KICK = 1 / 12
BAR_SUM = 1e-6
BAR_LOW = -0.1
BAR_HIGH = 1.1
PICTURE = Path(__file__).parent.parent / "docs" / "pictures" / "interruptions.svg"
SHOWN = (61.0, 9.0)
"""Start and length of the picture, seconds."""
CHUNK = 512

Values = NDArray[np.float64]
Floats = NDArray[np.float32]
Rows = NDArray[np.int64]
Claim = tuple[str, str, bool]


# --- the log and the two engines --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Order:
    """One call of the log."""

    time: float
    name: str
    seconds: float


@dataclass(frozen=True)
class Track:
    """One axis over the whole log: weights (N, names), and the largest rate within each step (N,), per second."""

    weights: Values
    rates: Values


def orders(rng: np.random.Generator, names: list[str], count: int) -> list[Order]:
    """Calls, each in the middle of the one before."""
    seconds = np.exp(rng.uniform(np.log(SHORTEST), np.log(LONGEST), count))
    times = np.concatenate([[0.1], 0.1 + np.cumsum(seconds * rng.uniform(0.0, 1.0, count))])
    chosen = rng.integers(0, len(names), count)
    return [Order(float(t), names[n], float(s)) for t, n, s in zip(times, chosen, seconds, strict=False)]


def play_log(log: list[Order], names: list[str], steps: int, *, inertial: bool) -> Track:
    """The axis through the log, looked at in each step."""
    column = {name: n for n, name in enumerate(names)}
    mixes = np.zeros((steps, len(names)))
    rates = np.zeros(steps)
    axis = Axis(names[0])
    since = 0.0
    for order in [*log, Order(steps / RATE, names[0], 1.0)]:
        first = int(np.ceil(since * RATE))
        last = min(steps, int(np.ceil(order.time * RATE)))
        for step in range(first, last):
            for name, weight in weights(advanced(axis, step / RATE - since)).items():
                mixes[step, column[name]] = weight
        _raise_rates(rates, axis, since, order.time)
        axis = called(advanced(axis, order.time - since), order.name, order.seconds, DEFAULT_EASING)
        if not inertial and axis.call is not None:
            axis = replace(axis, call=replace(axis.call, velocity={}, decay=0.0))
        since = order.time
    return Track(mixes, rates)


def _raise_rates(rates: Values, axis: Axis, start: float, end: float) -> None:
    """Raises the rates of the steps between two calls to the largest that the call's polynomials reach there."""
    call = axis.call
    if call is None or call.seconds is None:
        return
    steps = np.arange(int(start * RATE), min(len(rates), int(np.ceil(end * RATE))))
    low = np.maximum(steps / RATE, start) - start
    high = np.minimum((steps + 1) / RATE, end) - start
    names = {*call.start, *call.velocity, call.target}
    way = 0.5 * sum(abs(float(name == call.target) - call.start.get(name, 0.0)) for name in names)
    carried = 0.5 * sum(abs(rate) for rate in call.velocity.values())
    fastest = way * _peak(low / call.seconds, high / call.seconds, _eased_rate, 0.5) / call.seconds
    if carried:
        fastest = fastest + carried * _peak(low / call.decay, high / call.decay, _bump_rate, 0.6)
    rates[steps] = np.maximum(rates[steps], fastest)


def _eased_rate(x: Values) -> Values:
    return np.array([EASINGS[DEFAULT_EASING].rate(value) if value < 1.0 else 0.0 for value in x])


def _bump_rate(u: Values) -> Values:
    return np.array([bump_rate(value) for value in u])


def _peak(low: Values, high: Values, rate: Callable[[Values], Values], turn: float) -> Values:
    """The largest absolute rate between low and high; the rate is monotone but for `turn`."""
    at_turn = np.where((low < turn) & (turn < high), abs(rate(np.array([turn]))[0]), 0.0)
    result: Values = np.maximum(np.maximum(np.abs(rate(low)), np.abs(rate(high))), at_turn)
    return result


# --- vertices ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Basis:
    """Compounds (faces * expressions, 3 V), and how far apart two of a vertex are along each axis (V,), metres."""

    compounds: Floats
    between_faces: Values
    between_expressions: Values


def basis(cast: Cast, faces: list[str], expressions: list[str]) -> Basis:
    """All compounds of the palette."""
    made = CompoundCache(cast)
    worn = np.stack([np.stack([made.skin(i, j) for j in expressions]) for i in faces])
    return Basis(worn.reshape(len(faces) * len(expressions), -1), _spread(worn), _spread(worn.swapaxes(0, 1)))


def _spread(worn: Floats) -> Values:
    """The largest distance along the first axis of (n, m, V, 3), over the second, per vertex."""
    farthest = np.zeros(worn.shape[2])
    for row in range(1, len(worn)):
        for other in range(row):
            farthest = np.maximum(farthest, np.linalg.norm(worn[row] - worn[other], axis=-1).max(axis=0))
    return farthest


def products(faces: Track, expressions: Track, steps: Rows) -> Values:
    """The weights of all compounds (steps, faces * expressions)."""
    outer = faces.weights[steps][:, :, None] * expressions.weights[steps][:, None, :]
    return outer.reshape(len(steps), -1)


def lengths(change: Values, compounds: Floats) -> Floats:
    """How far each vertex goes (steps, V) when the weights change so (steps, faces * expressions), metres."""
    moved = (change.astype(np.float32) @ compounds).reshape(len(change), -1, 3)
    result: Floats = np.sqrt((moved * moved).sum(axis=-1))
    return result


def chunks(steps: Rows) -> Iterator[Rows]:
    """The steps, some at a time."""
    for first in range(0, len(steps), CHUNK):
        yield steps[first : first + CHUNK]


def moved_beyond(faces: Track, expressions: Track, base: Basis, steps: Rows, every: int) -> float:
    """The largest share of its allowance that any of every n-th vertex moves in any of these steps."""
    compounds = base.compounds.reshape(len(base.compounds), -1, 3)[:, ::every].reshape(len(base.compounds), -1)
    compounds = np.ascontiguousarray(compounds)
    worst = 0.0
    for some in chunks(steps):
        moved = lengths(products(faces, expressions, some + 1) - products(faces, expressions, some), compounds)
        turned = faces.rates[some] * _largest_sum(expressions, some)
        worn = expressions.rates[some] * _largest_sum(faces, some)
        allowed = np.outer(turned, base.between_faces[::every]) + np.outer(worn, base.between_expressions[::every])
        worst = max(worst, float((moved / np.maximum(allowed / RATE, 1e-7)).max()))
    return worst


def _largest_sum(track: Track, steps: Rows) -> Values:
    """A bound of the sum of absolute weights anywhere in the step."""
    result: Values = np.abs(track.weights[steps]).sum(axis=1) + 2.0 * track.rates[steps] / RATE
    return result


def largest_kick(faces: Track, expressions: Track, base: Basis, steps: Rows) -> tuple[float, int]:
    """The largest change of velocity of any vertex at these inner steps, m/s, and how many had to be looked at."""
    bound = _kick_bound(faces, expressions, base)[steps - 1]
    order = steps[np.argsort(-bound)]
    sorted_bound = np.sort(bound)[::-1]
    worst = 0.0
    looked = 0
    for some in chunks(order):
        if sorted_bound[looked] <= worst:
            break
        change = products(faces, expressions, some + 1) + products(faces, expressions, some - 1)
        change -= 2.0 * products(faces, expressions, some)
        worst = max(worst, float(lengths(change, base.compounds).max()))
        looked += len(some)
    return worst * RATE, looked


def _kick_bound(faces: Track, expressions: Track, base: Basis) -> Values:
    """A bound of the second difference of every vertex at the inner steps, metres, from the weights alone.

    The second difference of s t is that of s times t, that of t times s, and the products of the first differences.
    """
    halves = []
    for track, other in ((faces, expressions), (expressions, faces)):
        total = np.abs(other.weights[1:-1]).sum(axis=1)
        halves.append(0.5 * np.abs(np.diff(track.weights, 2, axis=0)).sum(axis=1) * total)
    steps = [0.5 * np.abs(np.diff(track.weights, axis=0)).sum(axis=1) for track in (faces, expressions)]
    crossed = 2.0 * (steps[0][1:] * steps[1][1:] + steps[0][:-1] * steps[1][:-1])
    result: Values = (halves[0] + crossed) * base.between_faces.max() + halves[1] * base.between_expressions.max()
    return result


# --- the picture ------------------------------------------------------------------------------------------------------


def speeds(faces: Track, expressions: Track, base: Basis, steps: Rows) -> Values:
    """The largest speed of any vertex in each step, m/s."""
    found = [
        lengths(products(faces, expressions, some + 1) - products(faces, expressions, some), base.compounds).max(axis=1)
        for some in chunks(steps)
    ]
    return RATE * np.concatenate(found).astype(np.float64)


WIDTH = 960
HEIGHT = 360
LEFT = 56
TOP = 48
ACROSS = WIDTH - LEFT - 16
UP = HEIGHT - TOP - 44
GREY = "#8a8f98"
LIGHT = "#d7dae0"
OURS = "#6fc3a8"
FREEZE = "#e0705a"


def draw(ours: Values, freeze: Values, calls: list[float]) -> str:
    """The picture: two curves over the same seconds, and a mark at each interruption."""
    ceiling = float(np.ceil(max(ours.max(), freeze.max()) * 50) / 50)
    levels = [(v, TOP + UP * (1 - v / ceiling)) for v in np.arange(0.0, ceiling + 0.001, 0.02)]
    seconds = range(int(SHOWN[1]) + 1)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="system-ui, sans-serif" '
        f'font-size="13"><rect width="{WIDTH}" height="{HEIGHT}" rx="8" fill="#14161a"/>',
        *(f'<path d="M{LEFT} {y:.1f}h{ACROSS}" stroke="#262a31"/>' for _, y in levels),
        *(_text(LEFT - 8, y + 4, f"{100 * v:.0f}", anchor="end") for v, y in levels),
        *(f'<path d="M{LEFT + ACROSS * (t - SHOWN[0]) / SHOWN[1]:.1f} {TOP}v{UP}" stroke="#3a3f48"/>' for t in calls),
        *(_text(LEFT + ACROSS * s / SHOWN[1], HEIGHT - 24, f"{s} s", anchor="middle") for s in seconds),
        _line(freeze / ceiling, FREEZE, 1.4),
        _line(ours / ceiling, OURS, 2.2),
        _text(LEFT, 24, "largest speed of any vertex, cm/s", LIGHT),
        _text(LEFT + 300, 24, "Omote", OURS),
        _text(LEFT + 370, 24, "plain freeze (1993)", FREEZE),
        _text(LEFT + 530, 24, "| a call interrupts the one before"),
    ]
    return "\n".join([*parts, "</svg>", ""])


def _line(values: Values, colour: str, width: float) -> str:
    places = zip(np.linspace(LEFT, LEFT + ACROSS, len(values)), TOP + UP * (1 - values), strict=True)
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="{width}"/>'


def _text(x: float, y: float, words: str, colour: str = GREY, anchor: str = "start") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" fill="{colour}" text-anchor="{anchor}">{words}</text>'


# --- the report -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Show:
    """The log and the compounds that it plays."""

    logs: tuple[list[Order], list[Order]]
    names: tuple[list[str], list[str]]
    base: Basis
    steps: int

    def around(self) -> Rows:
        """The inner steps around every interruption."""
        at = np.array([int(order.time * RATE) for log in self.logs for order in log])
        near = np.unique(at[:, None] + np.arange(-2, 4))
        return near[(near >= 1) & (near < self.steps - 1)]


def show(cast: Cast) -> Show:
    """Ten thousand calls of every face and every performed expression."""
    rng = np.random.default_rng(SEED)
    expressions = [name for name, title in cast.titles.items() if title.kind in ("neutral", "performed")]
    names = ["generic", *sorted(set(cast.faces) - {"generic"})], ["neutral", *sorted(set(expressions) - {"neutral"})]
    logs = orders(rng, names[0], COUNT // 2), orders(rng, names[1], COUNT // 2)
    steps = int(max(log[-1].time for log in logs) * RATE)
    return Show(logs, names, basis(cast, *names), steps)


def measure_claims(played_show: Show, ours: tuple[Track, Track], freeze: tuple[Track, Track]) -> dict[str, Claim]:
    """What was found, the bar and whether it is met, by claim."""
    base = played_show.base
    around = played_show.around()
    inner = np.arange(1, played_show.steps - 1)
    share = max(moved_beyond(*ours, base, around, 1), moved_beyond(*ours, base, inner, 16))
    kick, looked = largest_kick(*ours, base, inner)
    frozen_kick, _ = largest_kick(*freeze, base, around)
    sums = max(float(np.abs(track.weights.sum(axis=1) - 1.0).max()) for track in ours)
    low = min(track.weights.min() for track in ours)
    high = max(track.weights.max() for track in ours)
    print(f"largest change of velocity: ours {1000 * kick:.2f} mm/s, plain freeze {1000 * frozen_kick:.2f} mm/s")
    print(f"steps whose vertices had to be looked at for it: {looked:,}")
    return {
        "way of a vertex in a step / what its peak speed allows": (f"{share:.3f}", "at most 1", share <= 1.0),
        "largest change of velocity / plain freeze": (
            f"1/{frozen_kick / kick:.1f}", "at most 1/12", kick <= BAR_KICK * frozen_kick,
        ),
        "weights sum to one": (f"{sums:.1e}", f"within {BAR_SUM:g}", sums <= BAR_SUM),
        "weights stay in range": (f"{low:.4f} ... {high:.4f}", "-0.1 ... 1.1", low >= BAR_LOW and high <= BAR_HIGH),
    }  # fmt: skip


def report(found: dict[str, Claim]) -> bool:
    """Prints what was found, and says whether every bar is met."""
    table = Table(title=f"{COUNT:,} random interruptions, {RATE} steps a second", title_justify="left")
    for column in ("claim", "measured", "bar", "met"):
        table.add_column(column)
    for claim, (value, bar, met) in found.items():
        table.add_row(claim, value, bar, "yes" if met else "NO")
    Console(width=150).print(table)
    return all(met for _, _, met in found.values())


def main() -> bool:
    """Plays, measures, draws and prints."""
    shown = show(omote.load_cast())
    (faces, expressions) = shown.logs
    steps = shown.steps
    print(f"{steps:,} steps ({steps / RATE / 60:.0f} minutes of show), {len(shown.base.compounds)} compounds")
    ours, freeze = (
        (
            play_log(faces, shown.names[0], steps, inertial=kept),
            play_log(expressions, shown.names[1], steps, inertial=kept),
        )
        for kept in (True, False)
    )
    window = np.arange(int(SHOWN[0] * RATE), int((SHOWN[0] + SHOWN[1]) * RATE))
    curves = speeds(*ours, shown.base, window), speeds(*freeze, shown.base, window)
    calls = [order.time for log in shown.logs for order in log if 0.0 <= order.time - SHOWN[0] <= SHOWN[1]]
    PICTURE.parent.mkdir(parents=True, exist_ok=True)
    PICTURE.write_text(draw(*curves, calls), encoding="utf-8")
    return report(measure_claims(shown, ours, freeze))


if __name__ == "__main__":
    sys.exit(0 if main() else 1)
