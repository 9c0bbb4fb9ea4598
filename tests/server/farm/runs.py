"""What tests of the farm share: a run on the synthetic cast, and a pool in this process."""

from collections.abc import Generator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from omote.server.farm.export_run import ExportRun
from omote.server.farm.fork_pool import WorkOutcome, try_work
from tests import synthetic
from tests.stage_data.heads import context


def make_run(folder: Path, **options: Any) -> ExportRun:
    """A run of every synthetic face with one expression, as numbers, which is quick."""
    given: dict[str, Any] = {"kind": ".npz", "faces": list(synthetic.FACES), "expressions": ["smile"], **options}
    return ExportRun(context(), folder, **given)


def pool_here(run: ExportRun, numbers: Sequence[int]) -> Generator[WorkOutcome]:
    """Bakes one face after the other in this process."""
    for number in numbers:
        yield try_work(partial(bake_here, run), number)


def bake_here(run: ExportRun, number: int) -> bytes:
    """Bakes a face of a run and writes its files."""
    return run.store(run.faces[number], run.bake(run.faces[number]))


def ignore(done: int, total: int, face: str, failure: str) -> None:
    """Follows nothing."""


def contents(folder: Path) -> dict[str, bytes]:
    """All files of a folder but records, by their paths from it."""
    files = [path for path in folder.rglob("*") if path.is_file() and path.parent.name != ".omote-export"]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}
