"""A motion curve as few bytes: its times to the bit, its numbers as float32.

Numbers of a face change little from frame to frame: each is stored as what differs of its bits from the frame before,
all first bytes of a column in a row, then all second ones, and so on, deflated. A float32 is off by 6e-8 of a weight
at most; the same numbers as float64 take two and a half times as many bytes.
"""

from __future__ import annotations

import zlib
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from omote.arrays import Values
from omote.perform.clips.clip_parts import PLACES
from omote.perform.clips.motion_curve import MOST_COLUMNS, MOST_NUMBERS, MotionCurve
from omote.perform.clips.sample import layout_of

LEVEL = 6
TIME = np.dtype("<u8")
NUMBER = np.dtype("<u4")
"""The bits of a time, and of another number."""


@dataclass(frozen=True)
class PackedMotion:
    """A curve as plain values. columns: their names; parts: the place of each among `PLACES`; frames: how many;
    times, numbers: their deflated bits."""

    columns: tuple[str, ...]
    parts: tuple[int, ...]
    frames: int
    times: bytes
    numbers: bytes


def rounded(curve: MotionCurve) -> MotionCurve:
    """The curve as it comes back once it has been packed."""
    return MotionCurve(curve.times, curve.layout, curve.table.astype("<f4").astype(np.float64))


def pack_motion(curve: MotionCurve) -> PackedMotion:
    """Packs a curve."""
    times = _deflated(curve.times[:, None].astype("<f8").view(TIME))
    numbers = _deflated(curve.table.astype("<f4").view(NUMBER))
    return PackedMotion(curve.layout.columns, curve.layout.parts, len(curve.times), times, numbers)


def unpack_motion(packed: PackedMotion) -> MotionCurve:
    """The curve that was packed; ValueError where it was none, before memory is taken for it."""
    columns = len(packed.columns)
    if packed.frames < 1 or columns > MOST_COLUMNS or packed.frames * columns > MOST_NUMBERS:
        raise ValueError(f"a motion has {packed.frames} frames of {columns} columns; it is damaged")
    if len(packed.parts) != columns or not all(0 <= part < PLACES for part in packed.parts):
        raise ValueError("a motion has columns without a part; it is damaged")
    times = _inflated(packed.times, packed.frames, 1, TIME).view("<f8")[:, 0]
    table: Values = _inflated(packed.numbers, packed.frames, columns, NUMBER).view("<f4").astype(np.float64)
    return MotionCurve(times.astype(np.float64), layout_of(packed.columns, packed.parts), table)


def _deflated(bits: NDArray[Any]) -> bytes:
    """The bits of numbers, a row for each frame."""
    changed = bits.copy()
    changed[1:] ^= bits[:-1]
    by_column = np.ascontiguousarray(changed.T).view(np.uint8).reshape(bits.shape[1], len(bits), bits.itemsize)
    return zlib.compress(np.ascontiguousarray(by_column.transpose(0, 2, 1)).tobytes(), LEVEL)


def _inflated(data: bytes, frames: int, columns: int, kind: np.dtype[Any]) -> NDArray[Any]:
    wanted = frames * columns * kind.itemsize
    try:
        plain = zlib.decompressobj().decompress(data, wanted + 1)
    except zlib.error as error:
        raise ValueError(f"the numbers of a motion cannot be read ({error}); it is damaged") from error
    if len(plain) != wanted:
        raise ValueError(f"a motion has {len(plain)} bytes; expected {wanted}: it is damaged")
    by_byte = np.frombuffer(plain, np.uint8).reshape(columns, kind.itemsize, frames)
    changed = np.ascontiguousarray(by_byte.transpose(0, 2, 1)).view(kind)[:, :, 0]
    return np.ascontiguousarray(np.bitwise_xor.accumulate(changed, axis=1).T)
