"""Every state of a disk that a loss of power can leave, from a record of what changed it.

The model, after Pillai et al., "All File Systems Are Not Created Equal" (OSDI 2014): what was synced is there. Of
writes and lengths of a file that were not, any may be missing and the last may be torn between two sectors. Names
change in their order (as journals of file systems keep it), up to any change since the folder was last synced.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

SECTOR = 512


@dataclass(frozen=True)
class Step:
    """A line of the record: a call, the number of its file, an offset or a length, bytes, and one or two names."""

    call: str
    number: int
    offset: int
    data: bytes
    name: str
    other: str


@dataclass(frozen=True)
class CrashState:
    """What lies on the disk by name, and the highest number acknowledged before, by what it was (`saved`, `played`)."""

    files: Mapping[str, bytes]
    acknowledged: Mapping[str, int]
    moment: int


def read_record(path: Path, /) -> list[Step]:
    """The steps of a record; none where nothing was recorded."""
    steps = []
    with path.open("rb") as file:
        while line := file.readline():
            call, number, offset, length, name, other = line.decode().rstrip("\n").split("\t")
            data = file.read(int(length))
            steps.append(Step(call, int(number), int(offset), data, name, other))
    return steps


@dataclass
class _Disk:
    names: dict[str, int]
    synced: dict[int, bytes]
    waiting: dict[int, list[Step]] = field(default_factory=dict)
    renames: list[Step] = field(default_factory=list)
    numbers: dict[int, int] = field(default_factory=dict)
    acknowledged: dict[str, int] = field(default_factory=dict)

    def take(self, step: Step) -> None:
        """Makes a step; files are counted anew, for a disk gives the number of a removed one again."""
        match step.call:
            case "saved" | "played":
                self.acknowledged[step.call] = step.number
            case "create":
                self.numbers[step.number] = len(self.synced)
                self.synced[len(self.synced)] = b""
                self.renames.append(replace(step, number=self.numbers[step.number]))
            case "rename" | "link" | "unlink":
                self.renames.append(step)
            case "write" | "truncate":
                self.waiting.setdefault(self.numbers[step.number], []).append(step)
            case "sync" if step.number in self.numbers:
                file = self.numbers[step.number]
                self.synced[file] = _apply(self.synced[file], self.waiting.pop(file, []))
            case "sync":  # of a folder
                self.names = _rename(self.names, self.renames)
                self.renames = []


def crash_states(before: Mapping[str, tuple[int, bytes]], steps: list[Step], /) -> Iterator[CrashState]:
    """Every state that differs from those before it.

    before: the files of the folder as the first step found them: their number on the disk, and their bytes.
    """
    order = {name: place for place, name in enumerate(before)}
    disk = _Disk(order, {order[name]: data for name, (_, data) in before.items()})
    disk.numbers = {number: order[name] for name, (number, _) in before.items()}
    seen = set[int]()
    for moment in range(len(steps) + 1):
        for state in _states_of(disk, moment):
            key = hash((tuple(sorted(state.files.items())), tuple(sorted(state.acknowledged.items()))))
            if key not in seen:
                seen.add(key)
                yield state
        if moment < len(steps):
            disk.take(steps[moment])


def _states_of(disk: _Disk, moment: int) -> Iterator[CrashState]:
    acknowledged = dict(disk.acknowledged)
    whole = {file: _apply(data, disk.waiting.get(file, [])) for file, data in disk.synced.items()}
    for kept in range(len(disk.renames) + 1):
        names = _rename(disk.names, disk.renames[:kept])
        for rest in (whole, disk.synced):
            for file in set(names.values()) & disk.waiting.keys() or {-1}:
                for data in _versions(disk.synced[file], disk.waiting[file]) if file >= 0 else [b""]:
                    files = {name: data if at == file else rest[at] for name, at in names.items()}
                    yield CrashState(files, acknowledged, moment)


def _versions(data: bytes, waiting: list[Step]) -> Iterator[bytes]:
    """A file with some of the steps since it was synced: the first few, all but one, one alone, the last one torn."""
    for count in range(len(waiting) + 1):
        yield _apply(data, waiting[:count])
    for place, step in enumerate(waiting):
        yield _apply(data, [step])
        yield _apply(data, waiting[:place] + waiting[place + 1 :])
        for cut in range(SECTOR, len(step.data), SECTOR):
            yield _apply(data, [*waiting[:place], replace(step, data=step.data[:cut])])


def _apply(data: bytes, steps: list[Step]) -> bytes:
    if not steps:
        return data
    made = bytearray(data)
    for step in steps:
        length = step.offset + len(step.data)
        made.extend(bytes(max(0, length - len(made))))
        if step.call == "truncate":
            del made[step.offset :]
        else:
            made[step.offset : length] = step.data
    return bytes(made)


def _rename(names: Mapping[str, int], steps: list[Step]) -> dict[str, int]:
    made = dict(names)
    for step in steps:
        match step.call:
            case "create":
                made[step.name] = step.number
            case "link" if step.name in made:
                made[step.other] = made[step.name]
            case "rename" if step.name in made:
                made[step.other] = made.pop(step.name)
            case "unlink":
                made.pop(step.name, None)
    return made
