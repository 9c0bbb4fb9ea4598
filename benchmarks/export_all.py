"""A cast baked into files: 100 faces x 86 units as GLB, with two workers beside one, and beside a plain loop.

loop: every face baked by the same function in this process, nothing written: what one core needs at least. numpy: NumPy
alone writes the same displacements (np.save): less than any file of a head can take. one, two: `omote export --all` in
one and in two processes, into an empty folder each. Faces are random mixes of three; rounds take turns, and what is
compared are medians of ratios within a round. cpu: seconds of processor in a round of two over those of one: above 1
the processes hinder each other (memory, caches). A machine that others use too gives each process its share only, so
a ratio of two over one needs two free cores; the load is printed.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # one core each; read when NumPy is loaded

import argparse
import io
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import median

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.extraction import mix_faces
from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.export_deltas import measure_deltas
from omote.interchange.export_face import ExportContext, choose_expressions, named_compound_meshes
from omote.model.cast import Cast
from omote.server.farm.export_run import ExportRun, bake_in_processes, run_export

BAR = 1.8
"""How many times faster two workers are than one, at least."""
UNITS = "arkit,makehuman"


@dataclass(frozen=True)
class Times:
    """Seconds of a round: by the clock, and of processors (this process and its children)."""

    clock: float
    cpu: float


def make_cast(base: Cast, count: int, rng: np.random.Generator) -> Cast:
    """A cast of random faces, each with a look of the base's."""
    made = [mix_faces(base, rng, number) for number in range(count)]
    looks = {face.name: base.looks[str(rng.choice(list(base.faces)))] for face in made}
    faces = {face.name: face for face in made}
    return replace(base, faces={**base.faces, **faces}, looks={**base.looks, **looks})


def used() -> float:
    """Seconds of processors of this process and of its children that have ended."""
    whose = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return sum(each.ru_utime + each.ru_stime for each in whose)


def timed(work: Callable[[], object]) -> Times:
    """How long a piece of work takes."""
    clock = time.perf_counter()
    cpu = used()
    work()
    return Times(time.perf_counter() - clock, used() - cpu)


def export(context: ExportContext, faces: list[str], units: list[str], jobs: int) -> None:
    """Exports faces into an empty folder."""
    with tempfile.TemporaryDirectory() as folder:
        run = ExportRun(context, Path(folder), ".glb", faces, units)
        done = run_export(run, bake_in_processes(jobs), lambda *_: None)
        assert len(done.exported) == len(faces), done.failed


def bake_plainly(context: ExportContext, faces: list[str], units: list[str]) -> None:
    """Bakes faces one after the other, and writes nothing."""
    run = ExportRun(context, Path(), ".glb", faces, units)
    for face in faces:
        run.bake(face)


def numpy_seconds(context: ExportContext, face: str, units: list[str]) -> float:
    """Seconds in which NumPy writes the displacements of a face."""
    poses = [(name, named_compound_meshes(context.cast, face, name)) for name in units]
    arrays = measure_deltas(context.cast, face, poses).moves

    def save() -> None:
        for array in arrays.values():
            np.save(io.BytesIO(), array)

    return timed(save).clock


def measure(context: ExportContext, faces: list[str], units: list[str], console: Console) -> dict[str, Times]:
    """One round: the loop, one worker and two."""
    works: dict[str, Callable[[], None]] = {
        "loop": lambda: bake_plainly(context, faces, units),
        "one": lambda: export(context, faces, units, 1),
        "two": lambda: export(context, faces, units, 2),
    }
    found = {name: timed(work) for name, work in works.items()}
    told = ", ".join(f"{name} {each.clock:.1f} s (cpu {each.cpu:.1f})" for name, each in found.items())
    console.print(f"{told}; load {os.getloadavg()[0]:.1f}")
    return found


def main() -> int:
    """Prints the ratios; 0 when the bar is held."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--faces", type=int, default=100)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--seed", type=int, default=int(np.random.default_rng().integers(1_000_000)))
    given = parser.parse_args()
    console = Console(width=120)
    cast = make_cast(load_cast(), given.faces, np.random.default_rng(given.seed))
    context = ExportContext(cast, load_meshes(), load_mask())
    units = choose_expressions(cast, UNITS)
    faces = [name for name in cast.faces if name.startswith("random ")]
    console.print(f"{len(faces)} faces x {len(units)} units, seed {given.seed}, load {os.getloadavg()[0]:.1f}")
    bake_plainly(context, faces[:1], units)  # kernels are loaded, the skin's layers decoded
    rounds = [measure(context, faces, units, console) for _ in range(given.rounds)]
    faster = median(each["one"].clock / each["two"].clock for each in rounds)
    table = Table("what", "median", "bar")
    table.add_row("two workers, times faster than one", f"{faster:.2f}", f">= {BAR}")
    table.add_row("one worker / loop, clock", f"{median(e['one'].clock / e['loop'].clock for e in rounds):.2f}", "")
    table.add_row("two workers / one, cpu", f"{median(e['two'].cpu / e['one'].cpu for e in rounds):.2f}", "")
    saved = numpy_seconds(context, faces[0], units) * len(faces)
    table.add_row("loop / numpy", f"{median(e['loop'].clock for e in rounds) / saved:.0f}", "")
    console.print(table)
    console.print(f"held: {'yes' if faster >= BAR else 'NO'}; load {os.getloadavg()[0]:.1f}")
    return 0 if faster >= BAR else 1


if __name__ == "__main__":
    sys.exit(main())
