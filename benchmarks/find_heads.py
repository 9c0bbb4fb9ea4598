"""Heads found in spoiled scans: found, asked about, or wrong in silence, by kind; `python -m benchmarks.find_heads`.

Requirements: no wrong place is accepted, most plain heads are found without a click, none takes more than 5 s of one
core at the pace of the machine (`benchmarks/pace.py`). Seeds are fresh each run, and printed. Asked are also all
animals, bodies without a head, and what is no head.
"""

from __future__ import annotations

import argparse
import time
from collections import defaultdict
from dataclasses import dataclass

import numpy as np

import omote
from benchmarks.pace import measure_pace
from benchmarks.scans.spoiled import Spoiled, click, draw_inputs
from omote.builtin import load_identity_modes
from omote.model.fitting.find_head import HeadPlacement, find_head
from omote.model.fitting.landmarks import SEVEN

# A place is wrong where it is turned by more degrees, or its landmarks are farther off, millimetres.
TURNED = 15.0
OFF = 15.0
SLOWEST = 5.0
"""Processor seconds where the pace is 1."""


@dataclass(frozen=True)
class Outcome:
    """How one input went: found, asked or wrong; degrees, millimetres and scale off; seconds of one core."""

    verdict: str
    degrees: float
    off: float
    scale: float
    seconds: float
    said: str


def try_input(space: omote.ParameterSpace, given: Spoiled) -> Outcome:
    """One input without clicks."""
    modes = load_identity_modes()
    start = time.thread_time()
    try:
        place = find_head(space, modes, given.scan)
    except ValueError as error:
        return Outcome("asked", np.nan, np.nan, np.nan, time.thread_time() - start, str(error))
    seconds = time.thread_time() - start
    degrees, off, scale = _measure(given, place)
    wrong = given.upright is None or degrees > TURNED or off > OFF
    verdict = "asked" if place.doubts else "wrong" if wrong else "found"
    return Outcome(
        verdict, degrees, off, scale, seconds, f"{place.residual:.2f} mm, {place.unit} {' '.join(place.doubts)}"
    )


def _measure(given: Spoiled, place: HeadPlacement) -> tuple[float, float, float]:
    """Degrees between the place's frame and the true one, millimetres between landmarks, scale over the true one."""
    if given.upright is None or given.marks is None:
        return np.nan, np.nan, np.nan
    trace = np.trace(place.similarity.rotation @ given.upright.T)
    degrees = float(np.degrees(np.arccos(max(min((trace - 1.0) / 2.0, 1.0), -1.0))))
    away = [np.linalg.norm(place.landmarks[name] - given.marks[name]) for name in SEVEN]
    return degrees, 1000.0 * given.unit * float(np.mean(away)), place.similarity.scale / given.unit


def try_clicks(space: omote.ParameterSpace, given: Spoiled, draw: np.random.Generator) -> bool:
    """Whether seven clicks place a head upright: within TURNED degrees of what its clicks say."""
    clicks = click(given, draw)
    place = find_head(space, load_identity_modes(), given.scan, landmarks=clicks)
    right = clicks["left_eye_outer"] - clicks["right_eye_outer"]
    up = clicks["left_eye_inner"] + clicks["right_eye_inner"] - clicks["mouth_left"] - clicks["mouth_right"]
    turn = place.similarity.rotation
    off = [np.degrees(np.arccos((turn @ way)[axis] / np.linalg.norm(way))) for way, axis in ((right, 0), (up, 1))]
    return bool(off[0] < TURNED and off[1] < 45.0 and place.inside.any())


def main() -> None:
    """The table of a run."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--inputs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=int(np.random.SeedSequence().generate_state(1)[0]))
    parser.add_argument("--kinds", default="", help="these alone, separated by commas; else all")
    asked = parser.parse_args()
    kinds = [kind for kind in asked.kinds.split(",") if kind]
    space = omote.load_cast().space
    table = defaultdict[str, list[Outcome]](list)
    clicked = list[bool]()
    print(f"seed {asked.seed}")
    for number, given in enumerate(draw_inputs(omote.load_cast(), asked.inputs, asked.seed, kinds=kinds)):
        outcome = try_input(space, given)
        table[given.kind].append(outcome)
        if outcome.verdict == "asked" and given.marks:
            clicked.append(try_clicks(space, given, np.random.default_rng([asked.seed, number])))
        print(f"{given.kind:17}{given.name:16}{outcome.verdict:6} {outcome.degrees:4.0f} deg {outcome.off:4.0f} mm "
              f"x{outcome.scale:.2f} {outcome.seconds:.1f} s: {outcome.said}", flush=True)  # fmt: skip
    _report(table, clicked)


def _report(table: dict[str, list[Outcome]], clicked: list[bool]) -> None:
    print(f"\n{'kind':17}  found asked wrong   degrees  mm   scale  s")
    for kind, rows in table.items():
        counts = [sum(row.verdict == verdict for row in rows) for verdict in ("found", "asked", "wrong")]
        found = [row for row in rows if row.verdict == "found"]
        middle = [np.median([getattr(row, name) for row in found]) if found else np.nan
                  for name in ("degrees", "off", "scale")]  # fmt: skip
        figures = " ".join(f"{value:5.{digits}f}" for value, digits in zip(middle, (1, 1, 2), strict=True))
        print(
            f"{kind:17} {counts[0]:6} {counts[1]:5} {counts[2]:5}   {figures} {max(row.seconds for row in rows):5.1f}"
        )
    rows = [row for each in table.values() for row in each]
    wrong = sum(row.verdict == "wrong" for row in rows)
    slow = max(row.seconds for row in rows)
    most = SLOWEST * measure_pace()
    print(f"{len(rows)} inputs, {wrong} wrong in silence (at most 0), slowest {slow:.1f} s (at most {most:.1f}), "
          f"{sum(clicked)} of {len(clicked)} asked placed by clicks")  # fmt: skip
    if wrong or slow > most:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
