"""Packs the entries of a minute: snapshots beside snapshots, and the values of each source byte by byte.

The values of a source are floats that hold most of their bits between two frames: each frame is written as what differs
from the one before (XOR), and all first bytes of all frames stand together, all second bytes, and so on (the shuffle
filter of HDF5 and Blosc), so that LZMA finds what is the same.
"""

from __future__ import annotations

import lzma
from collections.abc import Iterator

import msgspec
import numpy as np

from omote.show.objects.sources import Drive
from omote.show.recording.entries import AnyEntry, Sent, SnapshotTaken, decode_entries, encode_entries

PRESET = 1
"""Of LZMA: a minute of two trackers takes .6 s and 1.35 MB with it, with 6 three times that and 5 % less."""
MOST_BYTES = 2**28
"""Of a minute that is unpacked: fifty times the largest of a night."""
Source = tuple[str, int, int]
"""Who sent, the index of the source, and how many bytes a frame has."""


class _Packed(msgspec.Struct, frozen=True, array_like=True):
    """others: all entries but snapshots, the values of frames left out; kept: snapshots; places: where these stand;
    frames: of each source in the order in which they came first, its values."""

    others: bytes
    kept: bytes
    places: list[int]
    frames: list[tuple[Source, bytes]]


def pack_entries(entries: list[AnyEntry]) -> bytes:
    """The bytes of the entries of a minute, packed."""
    frames: dict[Source, list[bytes]] = {}
    others = [_without_values(entry, frames) for entry in entries if not isinstance(entry, SnapshotTaken)]
    places = [place for place, entry in enumerate(entries) if isinstance(entry, SnapshotTaken)]
    packed = _Packed(
        encode_entries(others),
        encode_entries([entry for entry in entries if isinstance(entry, SnapshotTaken)]),
        places,
        [(source, _shuffle(values)) for source, values in frames.items()],
    )
    return lzma.compress(msgspec.msgpack.encode(packed), preset=PRESET)


def unpack_entries(data: bytes) -> list[AnyEntry]:
    """The entries again; ValueError where the bytes are damaged."""
    try:
        unpacker = lzma.LZMADecompressor()
        whole = unpacker.decompress(data, MOST_BYTES)
    except lzma.LZMAError as error:
        raise ValueError("a minute of the recording is damaged") from error
    if not unpacker.eof:
        raise ValueError("a minute of the recording is damaged, or too large")
    packed = msgspec.msgpack.decode(whole, type=_Packed)
    values = {source: iter(_unshuffle(shuffled, source[2])) for source, shuffled in packed.frames}
    entries = [_with_values(entry, values) for entry in decode_entries(packed.others)]
    for place, kept in zip(packed.places, decode_entries(packed.kept), strict=True):
        entries.insert(place, kept)
    return entries


def _without_values(entry: AnyEntry, frames: dict[Source, list[bytes]]) -> AnyEntry:
    """The entry with the number of its values in their place, which are added to the frames of their source."""
    if not (isinstance(entry, Sent) and isinstance(entry.message, Drive)) or not entry.message.values:
        return entry
    values = entry.message.values
    frames.setdefault((entry.who, entry.message.index, len(values)), []).append(values)
    length = len(values).to_bytes(2, "little")
    return msgspec.structs.replace(entry, message=msgspec.structs.replace(entry.message, values=length))


def _with_values(entry: AnyEntry, values: dict[Source, Iterator[bytes]]) -> AnyEntry:
    if not (isinstance(entry, Sent) and isinstance(entry.message, Drive)) or not entry.message.values:
        return entry
    length = int.from_bytes(entry.message.values, "little")
    found = next(values[entry.who, entry.message.index, length])
    return msgspec.structs.replace(entry, message=msgspec.structs.replace(entry.message, values=found))


def _shuffle(values: list[bytes]) -> bytes:
    """Frames of one length, each as what differs from the one before, bytes of one place together."""
    frames = np.frombuffer(b"".join(values), np.uint8).reshape(len(values), -1).copy()
    frames[1:] ^= frames[:-1].copy()
    return frames.T.tobytes()


def _unshuffle(shuffled: bytes, length: int) -> list[bytes]:
    frames = np.frombuffer(shuffled, np.uint8).reshape(length, -1).T
    return [row.tobytes() for row in np.bitwise_xor.accumulate(frames, axis=0)]
