"""Records all parts side by side, one process for each core, and compares two recordings."""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ProcessPoolExecutor, as_completed
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path

from tools.same.recording import Recording, compared

PARTS = ("compounds", "wire", "stage")
# Set before the processes start: sums by several threads, or in the order of a set, might come out another way.
STILL = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1", "PYTHONHASHSEED": "0"}


@dataclass(frozen=True)
class Job:
    """Something to record by itself: which function (`task`) with which arguments."""

    part: str
    task: str
    arguments: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        """What progress says."""
        return " ".join((f"{self.part}:", self.task, *self.arguments))


def jobs(faces: Sequence[str], parts: Sequence[str]) -> list[Job]:
    """Everything to record of these parts, the longest first."""
    found = [Job("stage", "positions"), Job("wire", "scenes"), Job("compounds", "own faces")]
    found += [Job("compounds", "extraction"), Job("wire", "editing"), Job("wire", "documents")]
    found += [Job("compounds", "frames", (mode, "smooth")) for mode in ("exact", "bilinear")]
    found += [Job("compounds", "solves"), Job("compounds", "recipes"), Job("wire", "show")]
    found += [Job("compounds", "face", (face, "smooth")) for face in faces]
    found += [Job("compounds", "frames", (mode, "paper")) for mode in ("exact", "bilinear")]
    found += [Job("compounds", "face", (face, "paper")) for face in faces]
    found += [Job("compounds", "fits")]
    return [job for job in found if job.part in parts]


def recorded(job: Job) -> Recording:
    """What one job records; in a process of its own."""
    from tools.same import authoring, compounds, documents, edit_link, show_link, stage

    recording = Recording()
    tasks: dict[str, Callable[..., None]] = {
        "positions": stage.record_stage,
        "scenes": documents.record_scenes,
        "documents": documents.record_documents,
        "show": show_link.record_session,
        "editing": edit_link.record_session,
        "own faces": authoring.record_faces,
        "extraction": authoring.record_extraction,
        "recipes": authoring.record_recipes,
        "solves": authoring.record_solves,
        "fits": compounds.record_fits,
        "face": compounds.record_face,
        "frames": compounds.record_frames,
    }
    tasks[job.task](recording, *job.arguments)
    return recording


def record(parts: Sequence[str]) -> Recording:
    """Everything of these parts; says how far it is."""
    os.environ.update(STILL)
    from omote.builtin import load_cast

    whole = Recording()
    began = time.monotonic()
    todo = jobs([*load_cast().faces], parts)
    with ProcessPoolExecutor(os.cpu_count(), mp_context=get_context("spawn")) as pool:
        running: Mapping[Future[Recording], Job] = {pool.submit(recorded, job): job for job in todo}
        for count, done in enumerate(as_completed(running), start=1):
            job = running[done]
            whole.add(job.part, done.result())
            print(f"{time.monotonic() - began:6.1f} s  {count:3d} of {len(todo)}  {job.title}", flush=True)
    return whole


def compare(before: Recording, after: Recording) -> bool:
    """Whether two recordings are the same; says what differs, group by group."""
    found = compared(before, after, sorted(before.hashes.keys() | after.hashes.keys()))
    for difference in sorted(found, key=lambda one: not one.same):
        print(difference)
    wrong = sum(not difference.same for difference in found)
    if not found:
        print("nothing was recorded: there is nothing to compare")
    else:
        print(f"{wrong} of {len(found)} groups differ" if wrong else f"all {len(found)} groups are the same")
    return bool(found) and not wrong


def main(arguments: Sequence[str] | None = None) -> int:
    """The command line; 1 where something differs."""
    parser = argparse.ArgumentParser(prog="python -m tools.same", description=__doc__)
    parser.add_argument("what", choices=("record", "compare"))
    parser.add_argument("file", type=Path, help="The recording: JSON; its numbers lie beside it as .npz.")
    parser.add_argument("--only", default=",".join(PARTS), help="Parts by commas: %(default)s.")
    parser.add_argument("--no-browser", action="store_true", help="Leave the stage out.")
    parser.add_argument(
        "--with", dest="other", type=Path, help="Compare with this recording instead of with this tree."
    )
    given = parser.parse_args(arguments)
    parts = [part for part in given.only.split(",") if not (given.no_browser and part == "stage")]
    if strange := [part for part in parts if part not in PARTS]:
        parser.error(f"there is no part {strange[0]!r}; name some of {', '.join(PARTS)}")
    if given.what == "record":
        record(parts).write(given.file)
        return 0
    before = Recording.read(given.file)
    after = Recording.read(given.other) if given.other else record(parts)
    return 0 if compare(before.of(parts), after.of(parts)) else 1
