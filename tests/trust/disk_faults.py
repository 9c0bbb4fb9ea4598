"""Tries every save path (`save_paths`) on a disk that loses its power at every moment, and on one that fails.

What must hold of a show afterwards is one table, `CHECKS`.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

import numpy as np

from omote.server.persistence.restore import open_newest
from omote.showfile.backup import backup_paths
from omote.showfile.changes import content_key
from omote.showfile.integrity import verify_integrity
from omote.showfile.show_file import ShowFile
from tests.trust.crash_states import CrashState, crash_states, read_record
from tests.trust.save_paths import FIRST, NAME, PATHS, save_data

SOURCE = Path(__file__).with_name("faulty_disk.c")
ROOT = SOURCE.parents[2]
SHORT_WRITE = -1
ERRORS: Mapping[str, int] = {
    "no space": errno.ENOSPC,
    "input/output error": errno.EIO,
    "quota": errno.EDQUOT,
    "not permitted": errno.EACCES,
    "short write": SHORT_WRITE,
}
"""How a call fails: of a short write half of the bytes are written, and other calls fail as by EIO."""
FOR_EVER = 2**31


@dataclass(frozen=True)
class Left:
    """What is left of a show: the folder, what was acknowledged, and the bytes of a damaged file that it began with."""

    folder: Path
    acknowledged: Mapping[str, int]
    damaged: bytes | None

    @property
    def path(self) -> Path:
        """The show file."""
        return self.folder / NAME


@dataclass
class Findings:
    """How much was tried of a path, and what was found: the name of a check and of what was done."""

    states: int = 0
    failures: int = 0
    found: Counter[str] = field(default_factory=Counter)
    examples: dict[str, str] = field(default_factory=dict)

    def take(self, checks: Iterator[str], what: str) -> None:
        """Counts the checks that do not hold of what was done."""
        for check in checks:
            self.found[check] += 1
            self.examples.setdefault(check, what)


def last_save(show: ShowFile) -> int:
    """The number of the last save that a show holds."""
    return int(show.stored().documents.get("layout", {}).get("count", b"0"))


def is_whole(show: ShowFile) -> bool:
    """Whether the last save has its bytes, and there are none of a later one; any before it may have failed."""
    keys = [content_key(save_data(number)) for number in range(1, last_save(show) + 1)]
    held = show.contents().keys()
    return held <= set(keys) and held >= set(keys[-1:])


CHECKS: Mapping[str, Callable[[ShowFile, Left], bool]] = {
    "every acknowledged save is there": lambda show, left: last_save(show) >= left.acknowledged["saved"],
    "a save is there whole or not at all": lambda show, left: is_whole(show),
    "every acknowledged state is there": lambda show, left: show.journal().epoch >= left.acknowledged["played"],
    "a corrupt file is kept": lambda show, left: (
        left.damaged is None or any(file.read_bytes() == left.damaged for file in left.folder.glob(f"{NAME}.corrupt-*"))
    ),
}
"""What must hold of a show that was opened again, by what people read; before that: that it opens, whole backups."""
OPENS = "the show opens"
WHOLE_BACKUPS = "every backup is whole"
NO_OTHER_ERROR = "a save fails as people are told"


def failing_checks(left: Left) -> Iterator[str]:
    """The checks that do not hold of what is left; opens the show, which writes."""
    try:
        for backup in backup_paths(left.path):
            verify_integrity(backup)
    except Exception:
        yield WHOLE_BACKUPS
    try:
        show = open_newest(left.path, lambda sentence: None)
    except Exception:
        yield OPENS
        return
    with closing(show):
        yield from (name for name, holds in CHECKS.items() if not holds(show, left))


class DiskTrial:
    """Save paths before a faulty disk, in one process that forks; made by `disk_trial`."""

    def __init__(self, folder: Path, process: subprocess.Popen[str], seed: int) -> None:
        self._folder = folder
        self._process = process
        self._seed = seed

    def lose_power(self, path: str, bug: str = "", most: int | None = None) -> Findings:
        """Checks the states of a path that a loss of power can leave.

        bug: one of `BUGS`, planted; most: so many drawn by the seed, and all that the end can leave; None for all.
        """
        before = self._prepared(path)
        answer = self._run(path, bug)
        states = list(crash_states(before, read_record(self._folder / "record")))
        findings = Findings()
        findings.take(iter([NO_OTHER_ERROR] if answer["said"] else []), answer["said"])
        drawn = set(islice(np.random.default_rng(self._seed).permutation(len(states)), most))
        for number, state in enumerate(states):
            if number not in drawn and state.moment < states[-1].moment:
                continue
            findings.states += 1
            left = self._written(state, before, path)
            findings.take(failing_checks(left), f"{path}: power lost after step {state.moment} (state {number})")
        return findings

    def fail_calls(self, path: str, bug: str = "", every: int = 1) -> Findings:
        """Lets calls of a path fail by each error, once and from then on.

        bug: one of `BUGS`, planted; every: 1 for each call, 2 for each second one.
        """
        self._prepared(path)
        calls = self._run(path, bug)["calls"]
        findings = Findings()
        for call in range(1 + self._seed % every, calls + 1, every):
            for error, number in ERRORS.items():
                for last in (call, FOR_EVER):
                    before = self._prepared(path)
                    answer = self._run(path, bug, (call, last), number)
                    what = f"{path}: {error} at call {call}{'' if last == call else ' and all after it'}"
                    findings.failures += 1
                    findings.take(iter([NO_OTHER_ERROR] if answer["said"] else []), f"{what}: {answer['said']}")
                    acknowledged = Counter[str]()
                    for step in read_record(self._folder / "record"):
                        acknowledged[step.call] = step.number
                    findings.take(failing_checks(self._left(acknowledged, before, path)), what)
        return findings

    def _prepared(self, path: str) -> dict[str, tuple[int, bytes]]:
        show = self._folder / "show"
        shutil.rmtree(show, ignore_errors=True)
        ready = self._folder / "prepared" / path
        prepare, _ = PATHS[path]
        if not ready.exists():
            ready.mkdir(parents=True)
            if prepare is not None:
                prepare(ready / NAME)
        shutil.copytree(ready, show)
        (self._folder / "record").write_bytes(b"")
        return {file.name: (file.stat().st_ino, file.read_bytes()) for file in show.iterdir()}

    def _run(self, path: str, bug: str, failing: tuple[int, int] = (0, -1), error: int = 0) -> dict[str, Any]:
        task = {"path": path, "bug": bug, "failing": failing, "error": error}
        task |= {"folder": str(self._folder / "show"), "record": str(self._folder / "record")}
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(json.dumps(task) + "\n")
        self._process.stdin.flush()
        answer: dict[str, Any] = json.loads(self._process.stdout.readline())
        return answer

    def _written(self, state: CrashState, before: Mapping[str, tuple[int, bytes]], path: str) -> Left:
        show = self._folder / "show"
        shutil.rmtree(show)
        for name, data in state.files.items():
            (show / name).parent.mkdir(parents=True, exist_ok=True)
            (show / name).write_bytes(data)
        show.mkdir(exist_ok=True)
        return self._left(state.acknowledged, before, path)

    def _left(self, acknowledged: Mapping[str, int], before: Mapping[str, tuple[int, bytes]], path: str) -> Left:
        first = FIRST if PATHS[path][0] is not None else 0
        kept = {"saved": max(first, acknowledged.get("saved", 0)), "played": acknowledged.get("played", 0)}
        return Left(self._folder / "show", kept, before[NAME][1] if path == "recover" else None)


@contextmanager
def disk_trial(folder: Path, seed: int) -> Iterator[DiskTrial]:
    """A process before a faulty disk (needs `cc`, Linux); folder: empty; seed: what is drawn."""
    library = folder / "faulty_disk.so"
    command = ["cc", "-shared", "-fPIC", "-O1", "-o", str(library), str(SOURCE), "-ldl"]
    subprocess.run(command, check=True)
    program = [sys.executable, "-m", "tests.trust.save_paths"]
    environment = os.environ | {"LD_PRELOAD": str(library), "DISK_FOLDER": "", "DISK_RECORD": ""}
    pipe = subprocess.PIPE
    with subprocess.Popen(program, cwd=ROOT, env=environment, stdin=pipe, stdout=pipe, text=True) as process:
        try:
            yield DiskTrial(folder, process, seed)
        finally:
            assert process.stdin is not None
            process.stdin.close()
