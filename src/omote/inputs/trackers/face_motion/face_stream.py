"""Frames of iFacialMocap and Facemotion3D in a stream of TCP: a mark ends a text frame, a binary one says its size."""

from __future__ import annotations

import re

from omote.inputs.trackers.face_motion.motion_message import HEADER, LONGEST_PAYLOAD, MAGIC
from omote.inputs.trackers.face_text import LONGEST_FRAME
from omote.inputs.trackers.tracker_frame import TrackerError

END = b"___iFacialMocap"
"""What a text frame ends with in a stream (ifacialmocap.com/for-developer)."""

TEXT_BEGINS = re.compile(rb"\s*\w*\s*(?:[-&|=#]|$|_)")
"""A name and what follows it. A web page can send to any port of this machine, with frames behind the first line of its
request, which begins otherwise."""


class FaceStream:
    """Cuts one connection's bytes into packets."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, data: bytes) -> list[bytes]:
        """The packets that have come whole; TrackerError where the stream cannot be read on, and is to be closed."""
        self._rest += data
        packets: list[bytes] = []
        while (packet := self._take()) is not None:
            if packet:
                packets.append(packet)
        return packets

    def _take(self) -> bytes | None:
        rest = self._rest
        if not rest or MAGIC.startswith(rest[: len(MAGIC)]) or rest.startswith(MAGIC):
            size = self._binary_size()
            if size is None or len(rest) < size:
                return None
            self._rest = rest[size:]
            return rest[:size]
        if not TEXT_BEGINS.match(rest):
            raise TrackerError(f"the stream has {rest[:16]!r} where a frame begins: its connection is ended")
        packet, mark, after = rest.partition(END)
        if not mark:
            if len(rest) > LONGEST_FRAME + len(END):
                raise TrackerError(f"the stream has {len(rest)} bytes without the end of a frame")
            return None
        self._rest = after
        return packet

    def _binary_size(self) -> int | None:
        """The bytes of the message that begins here; None while its header is not whole."""
        if len(self._rest) < HEADER.size:
            return None
        length = int(HEADER.unpack_from(self._rest)[-1])
        if length > LONGEST_PAYLOAD:
            raise TrackerError(f"a message in the stream says {length} bytes, but at most {LONGEST_PAYLOAD} are read")
        return HEADER.size + length
