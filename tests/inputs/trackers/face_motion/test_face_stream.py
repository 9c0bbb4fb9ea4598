"""Frames in a stream of TCP: cut anywhere, text and binary, and what never ends is refused."""

import itertools
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.trackers.face_motion.face_stream import END, FaceStream
from omote.inputs.trackers.face_motion.motion_message import Kind, MotionMessage
from omote.inputs.trackers.tracker_frame import TrackerError

FIRST = b"jawOpen&50|=head#1,2,3,4,5,6|"
SECOND = b"jawOpen&25|"
BINARY = MotionMessage(Kind.FRAME, 1, 1, payload=b"FMV3___iFacialMocap").encode()
STREAM = FIRST + END + BINARY + SECOND + END + END + BINARY


@given(st.lists(st.integers(0, len(STREAM)), max_size=8))
def test_packets_come_whole_wherever_the_stream_is_cut(cuts: list[int]) -> None:
    stream = FaceStream()
    places = [0, *sorted(cuts), len(STREAM)]
    found = [packet for at, to in itertools.pairwise(places) for packet in stream.feed(STREAM[at:to])]
    assert found == [FIRST, BINARY, SECOND, BINARY]


def test_a_text_that_never_ends_and_a_length_that_cannot_be_are_refused() -> None:
    with pytest.raises(TrackerError, match="without the end of a frame"):
        FaceStream().feed(b"x" * 20_000)
    damaged = bytearray(BINARY)
    damaged[36:40] = struct.pack("<I", 1 << 31)
    with pytest.raises(TrackerError, match="says 2147483648 bytes"):
        FaceStream().feed(bytes(damaged))


@pytest.mark.parametrize("first", [b"POST / HTTP/1.1\r\n\r\n", b"GET /x HTTP/1.1\r\n", b"\x16\x03\x01\x02\x00"])
def test_the_request_of_a_web_page_is_no_stream_of_frames(first: bytes) -> None:
    with pytest.raises(TrackerError, match="its connection is ended"):
        FaceStream().feed(first + END + SECOND + END)
