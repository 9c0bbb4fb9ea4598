"""Faces are read plainly here: by one point of the lower lip."""

import pytest

from tests.inputs.performers.landmarks import PlainTracker


@pytest.fixture(autouse=True)
def plain_tracker(monkeypatch: pytest.MonkeyPatch) -> None:
    """Has every performer read by the plain tracker."""
    monkeypatch.setattr("omote.inputs.performers.camera_performer.PerformerTracker", PlainTracker)
