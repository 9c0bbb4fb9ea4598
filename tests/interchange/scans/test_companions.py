"""Files beside a scan: what is missing or damaged is told once."""

import numpy as np

from omote.interchange.scans.companions import Companions
from tests.interchange.scans import scan_samples as samples


def test_a_picture_comes_and_what_is_missing_or_damaged_is_told_once() -> None:
    beside = Companions({"head.png": samples.picture_bytes(), "text.png": b"hello"}.get)
    np.testing.assert_array_equal(beside.picture("head.png"), samples.picture())
    assert [beside.picture(name) for name in ("gone.png", "gone.png", "text.png")] == [None, None, None]
    assert [note.split(" ", 4)[-1].split(" ")[0] for note in beside.notes] == ["not", "be"]


def test_what_cannot_be_opened_is_told() -> None:
    def locked(_: str) -> bytes:
        raise PermissionError(13, "no")

    beside = Companions(locked)
    assert beside.picture("a.png") is None
    assert beside.notes == ["its texture 'a.png' cannot be read (you are not allowed to)"]
