"""The terminal hears of rejections once a second."""

from omote.server.devices.rejection_log import RejectionLog


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
