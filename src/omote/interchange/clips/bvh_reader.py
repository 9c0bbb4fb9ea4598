"""Reads BVH, the text format of motion capture, from files of strangers: joints with offsets, and angles by frames.

What a file declares is checked before memory is taken for it. M. Meredith, S. Maddock: Motion capture file formats
explained, 2001, section 3.
"""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from omote.arrays import Values
from omote.interchange.clips.humanoid_motion import check_size

LARGEST = 64 * 2**20
"""Bytes of a file."""
LONGEST_HIERARCHY = 2**20
"""Letters."""
MOST_JOINTS = 512
"""With the ends of bones."""
MOST_CHANNELS = 6
FARTHEST = 1e6
"""Units of a file that an offset or a place may be from another; and degrees of an angle."""
SLOWEST_STEP = 1.0
FASTEST_STEP = 1.0 / 1000.0
"""Seconds between frames."""
_CHANNEL = re.compile(r"[XYZ](rotation|position)", re.IGNORECASE)
_MOTION = re.compile(r"^\s*MOTION\s+Frames:\s*(\S+)\s+Frame\s+Time:\s*(\S+)", re.IGNORECASE | re.MULTILINE)


@dataclass(frozen=True)
class BvhJoint:
    """name: as the file has it, "" of the end of a bone; parent: its place, -1 of a root; offset: from the parent at
    rest, units of the file; channels: what its numbers are, as `Xrotation`, in their order; first: the column of the
    first of them."""

    name: str
    parent: int
    offset: tuple[float, float, float]
    channels: tuple[str, ...] = ()
    first: int = 0


@dataclass(frozen=True, eq=False)
class BvhFile:
    """joints: parents before their children; step: seconds between frames; table (n, c): places, and degrees; notes:
    what is amiss, in sentences."""

    joints: tuple[BvhJoint, ...]
    step: float
    table: Values
    notes: tuple[str, ...] = ()


def read_bvh(data: bytes) -> BvhFile:
    """The joints and frames of a file.

    data: the file.

    Raises
    ------
    ValueError
        For what is no BVH, is cut off in its hierarchy, or is too large.
    """
    if len(data) > LARGEST:
        raise ValueError(f"the file has {len(data)} bytes; expected {LARGEST} at most: cut it into parts")
    text = data.decode("utf-8-sig", errors="replace")
    head = text[:LONGEST_HIERARCHY]
    if not head.lstrip().upper().startswith("HIERARCHY"):
        raise ValueError("the file does not begin with HIERARCHY, so it is no BVH; export the motion as BVH")
    motion = _MOTION.search(head)
    if motion is None:
        raise ValueError("the file has no MOTION with Frames and Frame Time, or far too many joints; export it anew")
    joints = _read_joints(head[: motion.start()])
    declared, step = _read_times(motion[1], motion[2])
    columns = sum(len(joint.channels) for joint in joints)
    check_size(declared, columns)
    table = _read_table(text[motion.end() :], columns, declared)
    notes = (f"it holds {len(table)} of the {declared} frames that it speaks of",) if len(table) < declared else ()
    return BvhFile(joints, step, table, notes)


def _read_times(frames: str, step: str) -> tuple[int, float]:
    """How many frames there are, and seconds between them."""
    seconds = _number(step, "the time of a frame")
    if not frames.isdecimal() or len(frames) > 9 or not FASTEST_STEP <= seconds <= SLOWEST_STEP:
        raise ValueError(
            f"the file has {frames[:20]!r} frames every {step[:20]} s; expected a number of them, "
            f"{FASTEST_STEP:g} to {SLOWEST_STEP:g} s apart: export it anew"
        )
    return int(frames), seconds


def _read_table(text: str, columns: int, declared: int) -> Values:
    """The numbers of all frames (n, columns), of those that are whole."""
    with warnings.catch_warnings():
        warnings.simplefilter("error", DeprecationWarning)
        try:
            numbers = np.fromstring(text, np.float64, count=-1, sep=" ")
        except (DeprecationWarning, ValueError) as error:
            raise ValueError("a frame holds what is no number; export it anew") from error
    whole = min(len(numbers) // columns, declared)
    if not whole:
        raise ValueError("the file has no whole frame; export it anew")
    table = numbers[: whole * columns].reshape(whole, columns)
    bad = np.flatnonzero(~(np.abs(table) <= FARTHEST).all(axis=1))
    if len(bad):
        raise ValueError(f"frame {bad[0] + 1} holds a number that is out of all reach; export it anew")
    return table


def _read_joints(text: str) -> tuple[BvhJoint, ...]:
    """The joints of the hierarchy; those that move at all have channels."""
    reader = _Hierarchy(iter(text.split()[1:]))
    reader.read()
    if reader.open or not reader.joints or not reader.columns:
        raise ValueError("the hierarchy is cut off, or nothing in it moves; copy or export it anew")
    return tuple(reader.joints)


class _Hierarchy:
    """Reads joints word by word. open: those whose braces are not closed yet; begun: one that has a name and no brace;
    columns: how many numbers a frame has so far."""

    def __init__(self, words: Iterator[str]) -> None:
        self.joints: list[BvhJoint] = []
        self.open: list[int] = []
        self.columns = 0
        self._words = words
        self._begun: int | None = None

    def read(self) -> None:
        """Reads all words."""
        for word in self._words:
            what = word.upper()
            if what in ("ROOT", "JOINT", "END"):
                self._begin(what)
            elif what in ("{", "}"):
                self._brace(what)
            elif what in ("OFFSET", "CHANNELS") and self.open and self._begun is None:
                self._tell(what)
            elif self._begun is not None:  # a name of several words
                joint = self.joints[self._begun]
                self.joints[self._begun] = replace(joint, name=joint.name and f"{joint.name} {word}"[:80])
            else:
                raise ValueError(f"the hierarchy has {word[:40]!r} where none is expected; export it anew")

    def _begin(self, what: str) -> None:
        if len(self.joints) >= MOST_JOINTS:
            raise ValueError(f"the file has more than {MOST_JOINTS} joints; export one person")
        if not self.open and self.joints:
            raise ValueError("the file has two roots; export each person into a file of its own")
        name = _next(self._words)
        parent = self.open[-1] if self.open else -1
        self.joints.append(BvhJoint("" if what == "END" else name, parent, (0.0, 0.0, 0.0)))
        self._begun = len(self.joints) - 1

    def _brace(self, brace: str) -> None:
        if brace == "{" and self._begun is not None:
            self.open.append(self._begun)
            self._begun = None
        elif brace == "}" and self.open:
            self.open.pop()
        else:
            raise ValueError(f"the hierarchy has {brace!r} where none is expected; export it anew")

    def _tell(self, what: str) -> None:
        place = self.open[-1]
        if what == "OFFSET":
            x, y, z = (_number(_next(self._words), "an offset") for _ in range(3))
            self.joints[place] = replace(self.joints[place], offset=(x, y, z))
            return
        channels = _read_channels(self._words)
        self.joints[place] = replace(self.joints[place], channels=channels, first=self.columns)
        self.columns += len(channels)


def _read_channels(words: Iterator[str]) -> tuple[str, ...]:
    count = _next(words)
    if not count.isdecimal() or not 0 <= int(count) <= MOST_CHANNELS:
        raise ValueError(f"a joint has {count[:20]!r} channels; expected {MOST_CHANNELS} at most: export it anew")
    channels = tuple(_next(words) for _ in range(int(count)))
    if not all(_CHANNEL.fullmatch(channel) for channel in channels) or len(set(channels)) != len(channels):
        raise ValueError(
            f"a joint has the channels {' '.join(channels)[:120]}; expected places and rotations about X, Y, Z"
        )
    return tuple(channel[0].upper() + channel[1:].lower() for channel in channels)


def _next(words: Iterator[str]) -> str:
    word = next(words, None)
    if word is None:
        raise ValueError("the hierarchy is cut off; copy or export the file anew")
    return word[:80]


def _number(word: str, what: str) -> float:
    try:
        number = float(word)
    except ValueError:
        number = math.nan
    if not abs(number) <= FARTHEST:
        raise ValueError(f"{what} is {word[:20]!r}; expected a number within {FARTHEST:g}: export it anew")
    return number
