"""Frames of landmarks come through unchanged or are rejected with what is wrong."""

import struct

import numpy as np
import pytest

from omote.inputs.camera.landmark_frame import (
    FARTHEST,
    LANDMARKS,
    LandmarkError,
    LandmarkFrame,
    read_landmark_frame,
    write_landmark_frame,
)

POINTS = np.random.default_rng(0).uniform(0, 1, (LANDMARKS, 3)).astype(np.float32)


def packet(
    signature: bytes = b"OMLM", version: int = 1, width: int = 640, height: int = 480, count: int = LANDMARKS,
    time: float = 1500.0, points: np.ndarray = POINTS,
) -> bytes:  # fmt: skip
    return struct.pack("<4sHHHHd", signature, version, width, height, count, time) + points.astype("<f4").tobytes()


def test_a_frame_reads_as_it_was_sent() -> None:
    frame = read_landmark_frame(packet())
    assert frame.found
    assert frame.points is not None
    assert np.array_equal(frame.points, POINTS)
    assert (frame.width, frame.height, frame.time) == (640, 480, 1.5)


def test_a_picture_without_a_face_reads_as_one() -> None:
    frame = read_landmark_frame(packet(count=0, points=POINTS[:0]))
    assert not frame.found
    assert frame.points is None


def test_what_is_written_reads_the_same() -> None:
    for sent in (packet(), packet(count=0, points=POINTS[:0])):
        assert write_landmark_frame(read_landmark_frame(sent)) == sent


@pytest.mark.parametrize(
    ("sent", "reason"),
    [
        (b"OMLM", "4 bytes"),
        (packet(signature=b"RIFF"), "begins with b'RIFF'"),
        (packet(version=2), "version 2"),
        (packet(count=468, points=POINTS[:468]), "468 points"),
        (packet()[:-1], "bytes; with 478 points"),
        (packet() + b"\0", "bytes; with 478 points"),
        (packet(count=0), "bytes; with 0 points"),
        (packet(width=0), "width is 0"),
        (packet(height=60000), "height is 60000"),
        (packet(time=float("nan")), "time is nan"),
        (packet(points=np.where(POINTS[3, 1] == POINTS, np.inf, POINTS)), "no number"),
        (packet(points=POINTS + 2 + FARTHEST), "pictures outside"),
    ],
)
def test_what_is_no_frame_is_rejected_with_the_reason(sent: bytes, reason: str) -> None:
    with pytest.raises(LandmarkError, match=reason):
        read_landmark_frame(sent)


def test_points_of_another_model_are_rejected() -> None:
    with pytest.raises(LandmarkError, match=r"shape \(468, 3\)"):
        LandmarkFrame(POINTS[:468], 640, 480, 0.0)


def test_points_are_read_only() -> None:
    frame = read_landmark_frame(packet())
    assert frame.points is not None
    with pytest.raises(ValueError, match="read-only"):
        frame.points[0] = 0
