"""Damaged files of scans and pictures: each is read, or refused with a sentence, in little time and memory.

Valid files of every format are written here, and real ones of ../shared/data are taken where they are; each is damaged
in random ways (bytes flipped, stretches cut, doubled, swapped, numbers replaced by extremes, bytes of another format),
with another seed in each run. A failure is any exception but ValueError, a warning, a ValueError without a sentence,
more than 2 s, or more than 1 GiB that one file takes. The peer: trimesh's loaders on the same meshes.
"""

from __future__ import annotations

import argparse
import io
import logging
import resource
import signal
import sys
import time
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from benchmarks.pace import measure_pace
from omote.interchange.scans.companions import Companions
from omote.interchange.scans.picture_reader import read_picture
from omote.interchange.scans.scan_reader import READERS, read_scan
from tests.interchange.scans import scan_samples as samples

DATA = Path(__file__).resolve().parents[2] / "shared" / "data"
REAL = (
    "mediapipe_canonical_apache/canonical_face_model.obj", "quaternius_animals_cc0/Fox.glb",
    "lee_perry_smith_ccby/LeePerrySmith.obj",
)  # fmt: skip
SLOW = 2.0 * measure_pace()
GREEDY = 2**30
"""Seconds and bytes that no file may take."""
EXTREMES = b"1e999 -1 0 99999999999999999999 nan 4294967295 2147483648 1e-320 0x10 1 255 1e30".split()
PATTERNS = [bytes.fromhex(digits) for digits in "00000000 ffffffff ffffff7f 00000080 7fc00000 0000807f 0a 2f".split()]


@dataclass
class Tally:
    """What came of the files of one kind."""

    files: int = 0
    read: int = 0
    refused: int = 0
    slowest: float = 0.0
    failures: Counter[str] = field(default_factory=Counter)
    peer: Counter[str] = field(default_factory=Counter)


def valid_files() -> dict[str, list[bytes]]:
    """Valid files by what is told of them: the suffix of a scan, or "picture"."""
    document, body = samples.gltf_document()
    inside, inside_body = samples.gltf_document(where="data")
    found = {
        ".ply": [
            samples.write_ply(order, coloured=coloured, corners=corners, quads=quads)
            for order in samples.ORDERS
            for coloured, corners, quads in (("", "", False), ("uchar", "face", True), ("float", "", True))
        ],
        ".stl": [samples.write_stl(), samples.write_stl(text=True)],
        ".obj": [samples.write_obj(), samples.write_obj(backwards=True, coloured=True)],
        ".glb": [samples.write_gltf(document, body)],
        ".gltf": [samples.write_gltf(inside, inside_body, binary=False)],
        ".xyz": [
            samples.write_cloud(), samples.write_cloud(";", coloured=True), samples.write_cloud(",", names="x,y,z"),
        ],
        "picture": [
            samples.picture_bytes(kind, np.tile(samples.picture(), (4, 4, 1)))
            for kind in ("PNG", "JPEG", "WEBP", "BMP", "GIF", "TIFF", "AVIF")
        ],
    }  # fmt: skip
    for name in REAL:
        if (path := DATA / name).exists():
            found[path.suffix].append(path.read_bytes())
    return found


def damage(random: np.random.Generator, data: bytes, others: list[bytes]) -> bytes:
    """A file damaged in one way, seldom in more."""
    changed = bytearray(data)
    for _ in range(int(random.geometric(0.6))):
        DAMAGES[int(random.integers(len(DAMAGES)))](random, changed, others)
    return bytes(changed)


def flip(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """Some bytes become others, most often near the beginning, where files say what is in them."""
    for _unused in range(int(random.integers(1, 9))):
        if data:
            reach = len(data) if random.random() < 0.5 else min(len(data), 600)
            data[int(random.integers(reach))] = int(random.integers(256))


def cut(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """The end goes, or a stretch."""
    begin, length = (int(value) for value in random.integers(0, len(data) + 1, 2))
    del data[begin : begin + (len(data) if random.random() < 0.5 else length)]


def double(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """A stretch comes twice."""
    begin = int(random.integers(len(data) + 1))
    length = int(random.integers(1, 2000))
    data[begin:begin] = data[begin : begin + length]


def swap(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """Two stretches change places."""
    if len(data) > 8:
        one, other = sorted(int(value) for value in random.integers(0, len(data), 2))
        length = min(int(random.integers(1, 400)), other - one, len(data) - other)
        data[one : one + length], data[other : other + length] = (
            data[other : other + length],
            data[one : one + length],
        )


def write_extreme(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """A number of the text becomes an extreme one."""
    reach = min(len(data), 4000 if random.random() < 0.7 else len(data))
    digits = [at for at in range(int(random.integers(max(reach, 1))), reach) if 48 <= data[at] <= 57][:1]
    for begin in digits:
        end = begin
        while end < len(data) and (48 <= data[end] <= 57 or data[end] in b".e-+"):
            end += 1
        data[begin:end] = EXTREMES[int(random.integers(len(EXTREMES)))]


def write_pattern(random: np.random.Generator, data: bytearray, _: list[bytes]) -> None:
    """Four bytes become an extreme number."""
    reach = min(len(data), 400 if random.random() < 0.5 else len(data))
    pattern = PATTERNS[int(random.integers(len(PATTERNS)))]
    at = int(random.integers(reach + 1))
    data[at : at + len(pattern)] = pattern


def splice(random: np.random.Generator, data: bytearray, others: list[bytes]) -> None:
    """A stretch comes from another file."""
    other = others[int(random.integers(len(others)))]
    begin = int(random.integers(len(other)))
    length = int(random.integers(1, 500))
    at = int(random.integers(len(data) + 1))
    data[at : at + length] = other[begin : begin + length]


DAMAGES: tuple[Callable[[np.random.Generator, bytearray, list[bytes]], None], ...] = (
    flip, flip, cut, double, swap, write_extreme, write_extreme, write_pattern, splice,
)  # fmt: skip


class TooSlowError(Exception):
    """A file took more than it may."""


def ring(*_: object) -> None:
    """Ends what takes too long."""
    raise TooSlowError("too slow")


def try_file(kind: str, data: bytes, tally: Tally, keep: Callable[[str], None]) -> None:
    """Reads one file and tallies what came of it."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    begun = time.thread_time()
    signal.setitimer(signal.ITIMER_REAL, 10 * SLOW)  # others use this machine: the measure is this thread's own time
    wrong = read_file(kind, data, tally)
    signal.setitimer(signal.ITIMER_REAL, 0)
    seconds = time.thread_time() - begun
    tally.files += 1
    tally.slowest = max(tally.slowest, seconds)
    grown = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
    wrong = wrong or (f"{seconds:.1f} s" if seconds > SLOW else f"{grown / 2**20:.0f} MiB" if grown > GREEDY else "")
    if wrong:
        tally.failures[wrong] += 1
        keep(wrong)


def read_file(kind: str, data: bytes, tally: Tally) -> str:
    """What is wrong with how a file was read or refused; "" for nothing."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # people would see it in their terminal
            if kind == "picture":
                read_picture(data)
            else:
                read_scan(kind, data, Companions({"ball.mtl": samples.MATERIAL, "head.png": PNG}.get))
        tally.read += 1
    except ValueError as error:
        tally.refused += 1
        return "" if len(str(error).split()) >= 5 else f"no sentence: {str(error)!r}"
    except Exception as error:
        return f"{type(error).__name__}: {str(error)[:60]}"
    return ""


def try_peer(kind: str, data: bytes, tally: Tally) -> None:
    """What trimesh makes of the same file."""
    import trimesh

    logging.getLogger("trimesh").disabled = True
    signal.setitimer(signal.ITIMER_REAL, 10 * SLOW)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            trimesh.load(io.BytesIO(data), file_type=kind[1:])
        tally.peer["read"] += 1
    except ValueError:
        tally.peer["ValueError"] += 1
    except Exception as error:
        tally.peer[type(error).__name__] += 1
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)


PNG = samples.picture_bytes()


def rounds(count: int) -> Iterator[int]:
    """The numbers of files, a line now and then."""
    for number in range(count):
        if number and number % 100_000 == 0:
            print(f"{number} of {count}", file=sys.stderr, flush=True)
        yield number


def measure(count: int, peer: int, seed: int, keep: Path | None) -> dict[str, Tally]:
    """Damages and reads `count` files; keep: a folder for those that fail."""
    random = np.random.default_rng(seed)
    files = valid_files()
    kinds = [*files]
    tallies = {kind: Tally() for kind in files}
    others = [data for group in files.values() for data in group]
    for number in rounds(count):
        kind = kinds[int(random.integers(len(kinds)))]
        group = files[kind]
        at = int(random.integers(len(group)))
        if len(group[at]) > 100_000 and random.random() < 0.95:  # real ones are large: fewer of them
            at = 0
        data = damage(random, group[at], others)

        def put_aside(wrong: str, data: bytes = data, kind: str = kind, number: int = number) -> None:
            print(f"file {number} of seed {seed}, {kind}: {wrong}", file=sys.stderr, flush=True)
            if keep is not None:
                keep.mkdir(parents=True, exist_ok=True)
                (keep / f"{seed}-{number}{kind if kind in READERS else '.picture'}").write_bytes(data)

        try_file(kind, data, tallies[kind], put_aside)
        if number < peer and kind in (".ply", ".stl", ".obj", ".glb", ".gltf", ".xyz"):
            try_peer(kind, data, tallies[kind])
    return tallies


def main() -> int:
    """Damages files, prints what came of them; 1 where one failed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=50_000, help="files in all")
    parser.add_argument("--peer", type=int, default=2_000, help="of them, those that trimesh reads too")
    parser.add_argument("--seed", type=int, default=int(np.random.SeedSequence().generate_state(1)[0]))
    parser.add_argument("--keep", type=Path, default=None, help="a folder for files that fail")
    chosen = parser.parse_args()
    signal.signal(signal.SIGALRM, ring)
    tallies = measure(chosen.count, chosen.peer, chosen.seed, chosen.keep)
    table = Table("kind", "files", "read", "refused", "failed", "slowest, s", "trimesh: read, ValueError, other")
    for kind, tally in tallies.items():
        other = sum(tally.peer.values()) - tally.peer["read"] - tally.peer["ValueError"]
        peer = f"{tally.peer['read']}, {tally.peer['ValueError']}, {other}" if tally.peer else ""
        failed = sum(tally.failures.values())
        table.add_row(
            kind, f"{tally.files}", f"{tally.read}", f"{tally.refused}", f"{failed}", f"{tally.slowest:.2f}", peer
        )
    console = Console()
    console.print(
        f"seed {chosen.seed}, most memory {resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MiB"
    )
    console.print(table)
    return int(any(tally.failures for tally in tallies.values()))


if __name__ == "__main__":
    sys.exit(main())
