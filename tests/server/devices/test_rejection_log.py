"""The terminal hears of rejections once a second."""

from dataclasses import dataclass

from omote.inputs.rejection import Rejection
from omote.server.devices.rejection_log import RejectionLog


@dataclass(eq=False)
class Device:
    rejected: int = 0
    last_rejection: Rejection | None = None


def test_one_line_a_second_whatever_comes() -> None:
    said: list[str] = []
    log = RejectionLog(said.append)
    for tick in range(180):
        for _ in range(1000):
            log.note(f"tick {tick}")
        log.tell(tick / 60)
    assert len(said) == 3
    assert said[:2] == ["tick 0 (1000 were rejected).", "tick 60 (60000 were rejected)."]
    assert log.total == 180_000


def test_a_single_rejection_is_not_counted_aloud_and_nothing_is_not_told() -> None:
    said: list[str] = []
    log = RejectionLog(said.append)
    log.tell(0.0)
    log.note("the face is missing.")
    log.tell(5.0)
    log.tell(9.0)
    assert said == ["the face is missing."]


def test_what_a_device_rejected_is_noted_once() -> None:
    said: list[str] = []
    log = RejectionLog(said.append)
    device = Device()
    log.note_new(device)
    device.rejected = 3
    device.last_rejection = Rejection(0.0, "desk", "no such face")
    log.note_new(device, "OSC from ")
    log.note_new(device)
    assert log.total == 3
    log.tell(0.0)
    assert said == ["OSC from desk: no such face (3 were rejected)."]
