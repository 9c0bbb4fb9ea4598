"""Exports many faces into a folder: in several processes, or on a cluster; what is whole and current is not made again.

Each face is one piece of work. Its files are written as soon as they are made, under a record (`export_record`), so
that a run which is ended at any instant goes on where it was.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import msgspec

from omote import __version__
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_face import ExportContext, named_compound_meshes
from omote.interchange.exports.export_formats import OBJ_FOLDER, bake_face, check_kind
from omote.interchange.exports.identifiers import identifiers
from omote.server.farm.export_record import (
    FOREIGN,
    ExportState,
    find_foreign,
    find_state,
    hash_content,
    open_folder,
    store_export,
)
from omote.server.farm.fork_pool import WorkOutcome, try_work, work_in_processes
from omote.server.farm.own_cast import key_of_face, key_of_options

Report = Callable[[int, int, str, str], None]
"""Told of each face that is done: how many are, how many there are, its name, and why it failed ("" where not)."""
Pool = Callable[["ExportRun", Sequence[int]], Generator[WorkOutcome]]
"""Makes the files of some faces of a run somewhere; a result is their bytes, "" where they are written already."""


class MadeFiles(msgspec.Struct, frozen=True):
    """The files of one face, by their paths from the folder."""

    files: dict[str, bytes]


@dataclass(frozen=True, eq=False)
class ExportRun:
    """All faces of one command, what they wear, and where their files go; kind: as `encode_face` has it.

    force: files are replaced that Omote did not write; credit: of avatars (VRM); body: of figures, as `encode_face` has
    it.
    """

    context: ExportContext = field(repr=False)
    folder: Path
    kind: str
    faces: Sequence[str]
    expressions: Sequence[str]
    hair: bool = True
    force: bool = False
    credit: Credit | None = None
    body: str = ""

    @cached_property
    def stems(self) -> Mapping[str, str]:
        """The name of each face's files, without ending."""
        return identifiers(self.faces)

    @cached_property
    def keys(self) -> Mapping[str, str]:
        """What each face's files are made of: they are the same where this is."""
        pictures = hash_content(self.context.layers)
        options = (__version__, self.kind, self.hair, repr(self.credit), pictures, *self._bodies)
        shared = key_of_options(self.context.cast, self.expressions, options)
        return {face: key_of_face(self.context.cast, face, shared) for face in self.faces}

    @property
    def _bodies(self) -> tuple[str, ...]:
        """What tells the bodies of figures apart; nothing for heads."""
        bodies = self.context.cast.bodies.values()
        return (self.body, hash_content(b"".join(body.positions.tobytes() for body in bodies))) if self.body else ()

    def record(self, face: str) -> str:
        """The name of a face's record."""
        return f"{self.stems[face]}.{self.kind.lstrip('.')}"

    def main(self, face: str) -> str:
        """The file, or the folder, that a face is exported to."""
        return self.stems[face] if self.kind == OBJ_FOLDER else f"{self.stems[face]}{self.kind}"

    def state(self, face: str) -> ExportState:
        """The state of a face's files."""
        return find_state(self.folder, self.record(face), self.keys[face], self.main(face))

    def refusal(self, face: str) -> str:
        """Why a face whose files somebody else changed is not written."""
        return f"{self.folder / find_foreign(self.folder, self.record(face), self.main(face))} {FOREIGN}"

    def bake(self, face: str) -> dict[str, bytes]:
        """The files of a face."""
        named = face, self.expressions, self.kind, self.stems[face]
        return bake_face(self.context, *named, hair=self.hair, credit=self.credit, body=self.body)

    def store(self, face: str, files: Mapping[str, bytes]) -> bytes:
        """Writes the files of a face and gives nothing back, as a piece of work does; errors as `store_export`."""
        store_export(self.folder, self.record(face), self.keys[face], files, force=self.force)
        return b""


@dataclass(frozen=True)
class Finished:
    """How a run ended: faces that were made, those whose files were current, and why others have none."""

    exported: Sequence[str]
    current: Sequence[str]
    failed: Mapping[str, str]


def run_export(run: ExportRun, pool: Pool, report: Report) -> Finished:
    """Makes what is not there yet. ValueError or OSError, with a sentence, where none could be made, or no more.

    run: the faces and what they wear; pool: makes their files; report: told of each.
    """
    check_kind(run.kind, run.credit)
    exported = list[str]()
    failed = dict[str, str]()
    with open_folder(run.folder):
        states = {face: run.state(face) for face in run.faces}
        current = [face for face, state in states.items() if state == "current"]
        if not run.force:
            failed = {
                face: f"{run.folder / run.main(face)} {FOREIGN}" for face in run.faces if states[face] == "foreign"
            }
        waiting = [number for number, face in enumerate(run.faces) if face not in {*current, *failed}]
        with closing(pool(run, waiting)) as outcomes:
            for face, outcome in ((run.faces[outcome.number], outcome) for outcome in outcomes):
                failure = _store_result(run, face, outcome)
                if failure:
                    failed[face] = failure
                else:
                    exported.append(face)
                report(len(exported) + len(current) + len(failed), len(run.faces), face, failure)
    return Finished(exported, current, failed)


def _store_result(run: ExportRun, face: str, outcome: WorkOutcome) -> str:
    """Writes what came as bytes; why that or the making failed, "" where neither did; OSError where all others would
    too."""
    if outcome.result:
        files = msgspec.msgpack.decode(outcome.result, type=MadeFiles).files
        outcome = try_work(lambda _: run.store(face, files), outcome.number)
    if outcome.final:
        raise OSError(
            f"{face}: {outcome.failure}; faces that are written stay, and the same command goes on from there"
        )
    return outcome.failure


def bake_in_processes(jobs: int) -> Pool:
    """A pool of so many processes of this machine, which write what they make."""

    def pool(run: ExportRun, numbers: Sequence[int]) -> Generator[WorkOutcome]:
        def work(number: int) -> bytes:
            return run.store(run.faces[number], run.bake(run.faces[number]))

        if numbers:
            warm_up(run)
        return work_in_processes(work, numbers, jobs)

    return pool


def warm_up(run: ExportRun) -> None:
    """Loads what every process would load for itself: kernels, and the skin's layers."""
    assert run.keys
    if run.kind not in (".npz", ".csv"):
        assert run.context.canvas
    for expression in run.expressions[:1]:
        named_compound_meshes(run.context.cast, run.faces[0], expression)
