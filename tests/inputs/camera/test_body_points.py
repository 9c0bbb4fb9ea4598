"""A frame of a body: what is written reads the same; a number that is none costs its point alone."""

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.inputs.camera.body_points import (
    BODY_POINTS,
    NUMBERS,
    BodyPoints,
    holds_body,
    read_body_points,
    write_body_points,
)
from omote.inputs.camera.landmark_frame import LandmarkError, LandmarkFrame, write_landmark_frame
from omote.inputs.rejection import PacketError

VALUES = np.random.default_rng(4).uniform(0.0, 1.0, (BODY_POINTS, NUMBERS)).astype(np.float32)
FRAME = BodyPoints(VALUES, 640, 480, 1.25)


def test_what_is_written_reads_the_same() -> None:
    for frame in (FRAME, BodyPoints(None, 320, 240, 0.5)):
        packet = write_body_points(frame)
        read = read_body_points(packet)
        assert (read.found, read.width, read.height, read.time) == (
            frame.found, frame.width, frame.height, frame.time,
        )  # fmt: skip
        assert read.values is None or (read.values == VALUES).all()
        assert holds_body(packet)
    assert not holds_body(write_landmark_frame(LandmarkFrame(None, 640, 480, 0.0)))


def test_axes_are_ours_and_a_point_outside_the_picture_is_unseen() -> None:
    assert FRAME.points[:, 0] == pytest.approx(VALUES[:, 0])
    assert FRAME.points[:, 1:] == pytest.approx(-VALUES[:, 1:3])
    assert FRAME.picture[:, 1] == pytest.approx(0.75 * VALUES[:, 5])
    values = VALUES.copy()
    values[3, 4:] = (0.5, 1.2)
    assert BodyPoints(values, 640, 480, 0.0).visible[3] == 0.0
    assert BodyPoints(values, 640, 480, 0.0).visible[4] == pytest.approx(VALUES[4, 3])


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1e30])
def test_a_number_that_is_none_costs_its_point_alone(wrong: float) -> None:
    values = VALUES.copy()
    values[7, 2] = wrong
    frame = BodyPoints(values, 640, 480, 0.0)
    others = np.arange(BODY_POINTS) != 7
    assert frame.visible[7] == 0.0
    assert np.isfinite(frame.points).all()
    assert (frame.points[others] == FRAME.points[others]).all()
    assert (frame.visible[others] == FRAME.visible[others]).all()


@pytest.mark.parametrize(
    ("packet", "said"),
    [
        (b"OMBL", "4 bytes"),
        (b"OMLM" + write_body_points(FRAME)[4:], "begins with"),
        (write_body_points(FRAME)[:4] + struct.pack("<H", 9) + write_body_points(FRAME)[6:], "version 9"),
        (write_body_points(FRAME)[:10] + struct.pack("<H", 5) + write_body_points(FRAME)[12:], "5 points"),
        (write_body_points(FRAME)[:-4], "bytes; with 33 points"),
    ],
)
def test_what_is_no_frame_is_refused_with_the_reason(packet: bytes, said: str) -> None:
    with pytest.raises(LandmarkError, match=said):
        read_body_points(packet)


def test_a_frame_without_a_body_has_no_points() -> None:
    with pytest.raises(ValueError, match="no body was found"):
        _ = BodyPoints(None, 640, 480, 0.0).points
    with pytest.raises(LandmarkError, match="width is 0"):
        BodyPoints(None, 0, 480, 0.0)
    with pytest.raises(LandmarkError, match="time is nan"):
        BodyPoints(None, 640, 480, float("nan"))
    with pytest.raises(LandmarkError, match="shape"):
        BodyPoints(np.zeros((3, 6), np.float32), 640, 480, 0.0)


@given(st.binary(max_size=900))
def test_no_packet_raises_anything_else(data: bytes) -> None:
    for packet in (data, write_body_points(FRAME)[:20] + data[:792].ljust(792, b"\xff")):
        try:
            frame = read_body_points(packet)
        except PacketError:
            continue
        assert frame.values is None or np.isfinite(frame.values).all()
