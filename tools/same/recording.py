"""What was recorded: a SHA-256 hash for each thing by group and key, and some of its numbers, to say how far off."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

EVERY = 7
"""Of how many numbers one is kept beside the hash."""
SENTENCES = "sentences"
"""The group of what people read: it may be reworded while all else stays the same."""

Numbers = NDArray[Any]


@dataclass
class Recording:
    """Hashes by group and key; samples: kept numbers by "group|key", with what one of them is in `units`."""

    hashes: dict[str, dict[str, str]] = field(default_factory=dict)
    samples: dict[str, Numbers] = field(default_factory=dict)

    def data(self, group: str, key: str, data: bytes) -> None:
        """Records bytes; ValueError where there is something under this key already."""
        known = self.hashes.setdefault(group, {})
        if key in known:
            raise ValueError(f"{group} has {key!r} twice; give each thing a key of its own")
        known[key] = hashlib.sha256(data).hexdigest()

    def numbers(self, group: str, key: str, *arrays: Any, every: int = EVERY) -> None:
        """Records arrays, their types and shapes; of their numbers, one in `every` is kept."""
        given = [np.ascontiguousarray(array) for array in arrays]
        shapes = repr([(array.dtype.str, array.shape) for array in given]).encode()
        self.data(group, key, b"".join([shapes, *(array.tobytes() for array in given)]))
        flat = np.concatenate([array.ravel().astype(np.float32) for array in given])
        self.samples[f"{group}|{key}"] = flat[::every].copy()

    def sentence(self, key: str, text: str) -> None:
        """Records what people read."""
        self.data(SENTENCES, key, text.encode())

    @contextmanager
    def refusal(self, group: str, key: str) -> Iterator[None]:
        """Records which error a block ends with (or none), and its words among the sentences."""
        try:
            yield
        except (ValueError, TypeError, KeyError) as error:
            kind = next(each for each in (KeyError, TypeError, ValueError) if isinstance(error, each))
            self.data(group, key, kind.__name__.encode())
            self.sentence(f"{group}: {key}", str(error))
        else:
            self.data(group, key, b"no error")

    def add(self, part: str, other: Recording) -> None:
        """Takes over all that another recording has, as groups of a part."""
        for group, hashes in other.hashes.items():
            known = self.hashes.setdefault(f"{part}: {group}", {})
            if twice := known.keys() & hashes.keys():
                raise ValueError(f"{group} has {sorted(twice)[0]!r} twice; give each thing a key of its own")
            known |= hashes
        self.samples |= {f"{part}: {name}": values for name, values in other.samples.items()}

    def of(self, parts: Iterable[str]) -> Recording:
        """Only the groups of these parts."""
        wanted = set(parts)
        hashes = {group: known for group, known in self.hashes.items() if group.partition(":")[0] in wanted}
        return Recording(hashes, self.samples)

    def write(self, path: Path) -> None:
        """Writes the hashes as JSON, and the numbers beside it as npz."""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(self.hashes, indent=1, sort_keys=True) + "\n")
        names = sorted(self.samples)
        numbers = [self.samples[name] for name in names]
        np.savez_compressed(
            path.with_suffix(".npz"),
            names=np.array(names),
            lengths=np.array([len(each) for each in numbers], np.int64),
            values=np.concatenate([np.zeros(0, np.float32), *numbers]),
        )

    @classmethod
    def read(cls, path: Path) -> Recording:
        """The recording in a file; its numbers are left out where the npz is missing."""
        recording = cls(json.loads(path.read_text()))
        beside = path.with_suffix(".npz")
        if beside.is_file():
            with np.load(beside) as file:
                parts = np.split(file["values"], np.cumsum(file["lengths"])[:-1])
                recording.samples = dict(zip(file["names"].tolist(), parts, strict=True))
        return recording


@dataclass(frozen=True)
class Difference:
    """How a group differs: keys that changed, are missing now, are new; greatest: of the kept numbers (None: none)."""

    group: str
    count: int
    changed: tuple[str, ...] = ()
    missing: tuple[str, ...] = ()
    new: tuple[str, ...] = ()
    greatest: float | None = None

    @property
    def same(self) -> bool:
        """Whether nothing differs."""
        return not (self.changed or self.missing or self.new)

    def __str__(self) -> str:
        if self.same:
            return f"same     {self.group}: {self.count}"
        parts = [
            f"{len(keys)} of {self.count} {what} ({', '.join(keys[:3])}{', ...' if len(keys) > 3 else ''})"
            for what, keys in (("changed", self.changed), ("missing", self.missing), ("new", self.new))
            if keys
        ]
        return f"DIFFERS  {self.group}: {'; '.join(parts)}{_far(self.group, self.greatest)}"


def compared(before: Recording, after: Recording, groups: Iterable[str]) -> list[Difference]:
    """What differs in each of these groups."""
    return [_difference(before, after, group) for group in groups]


def _difference(before: Recording, after: Recording, group: str) -> Difference:
    old = before.hashes.get(group, {})
    new = after.hashes.get(group, {})
    changed = tuple(key for key in old if key in new and old[key] != new[key])
    names = [name for key in changed if (name := f"{group}|{key}") in before.samples and name in after.samples]
    return Difference(
        group,
        len(old.keys() | new.keys()),
        changed,
        tuple(key for key in old if key not in new),
        tuple(key for key in new if key not in old),
        max((_apart(before.samples[name], after.samples[name]) for name in names), default=None),
    )


def _apart(one: Numbers, other: Numbers) -> float:
    if one.shape != other.shape:
        return float("inf")
    return float(np.abs(one.astype(np.float64) - other).max(initial=0.0))


def _far(group: str, greatest: float | None) -> str:
    if greatest is None:
        return ""
    if group.startswith("stage"):
        return f"; greatest difference {1000 * greatest:.6f} mm"
    return f"; greatest difference {greatest:.3g} of the numbers kept (1 in {EVERY}; positions are metres)"
