"""Health of devices and sources: rates, newest values, and looks that cost the same however much came."""

from dataclasses import replace

import pytest

from omote.inputs.page_devices.device_health import MOST_VALUES, DeviceHealth, SourceCounts, SourceHealth
from omote.inputs.page_devices.input_log import LineLog
from omote.inputs.rejection import Rejection
from omote.inputs.trackers.tracker_input import SenderCounts


def test_the_rate_is_of_the_last_second() -> None:
    health = DeviceHealth(0.0)
    for n in range(180):
        health.note()
        health.rate(n / 60)
    assert health.rate(3.0) == pytest.approx(60.0, rel=0.05)
    health.rate(4.1)
    assert health.rate(5.2) == 0.0


def test_the_newest_values_are_kept() -> None:
    health = DeviceHealth(0.0)
    for n in range(2 * MOST_VALUES):
        health.read(f"cc{n}", n / 1000)
    assert list(health.values) == [f"cc{n}" for n in range(MOST_VALUES, 2 * MOST_VALUES)]


def test_a_look_at_a_source_logs_what_is_new_once() -> None:
    log = LineLog()
    counts = SourceCounts("OSC", "osc", "10.0.0.5", 40, 2, "/omote/panic", Rejection(0.0, "10.0.0.5", "no"))
    source = SourceHealth(lambda: counts)
    state = source.look(2.0, log)
    assert (state.heard, state.rejected, state.where, state.rate) == (40, 2, "10.0.0.5", 20.0)
    assert [(line.text, line.count) for line in log.lines] == [("/omote/panic", 40), ("10.0.0.5: no", 2)]
    source.look(2.1, log)
    assert len(log.lines) == 2


def test_what_came_of_several_controls_is_not_counted_as_one() -> None:
    log = LineLog()
    counts = SourceCounts("OSC", "osc", "10.0.0.5", 1, 0, "/a 1", alike=1)
    source = SourceHealth(lambda: counts)
    source.look(0.0, log)
    counts = replace(counts, heard=4, newest="/d 1", alike=1)
    source.look(1.0, log)
    counts = replace(counts, heard=7, newest="/d 4", alike=4)
    source.look(2.0, log)
    assert [(line.text, line.count) for line in log.lines] == [
        ("/a 1", 1),
        ("/d 1 (and 2 of others before it)", 1),
        ("/d 4", 3),
    ]


def test_a_remark_is_logged_once_and_is_no_rejection() -> None:
    log = LineLog()
    remark = Rejection(0.0, "VMC from 10.0.0.5", "HeartRate is left out")
    source = SourceHealth(lambda: SourceCounts("VMC", "tracker", "", 40, 0, remarks=1, remark=remark))
    for look in range(3):
        assert source.look(2.0 + look, log).rejected == 0
    assert [(line.text, line.rejected) for line in log.lines] == [("VMC from 10.0.0.5: HeartRate is left out", False)]


def test_each_sender_of_a_face_is_one_line_that_shows_what_moves() -> None:
    log = LineLog()
    heard = {"Ada": 0, "Ben": 0}
    jaw = {"Ada": 0.0, "Ben": 0.0}

    def probe() -> SourceCounts:
        senders = tuple(
            SenderCounts(name, count, {"cheekPuff": 0.0, "jawOpen": jaw[name]}) for name, count in heard.items()
        )
        return SourceCounts("Live Link Face", "tracker", "", sum(heard.values()), 0, senders=senders)

    source = SourceHealth(probe)
    for look in range(50):
        heard["Ada"] += 6
        heard["Ben"] += 3 if look < 20 else 0
        jaw["Ada"] = look / 50
        source.look(look / 10, log)
    told = {line.text: line for line in log.lines}
    assert len(told) == len(log.lines) == 2
    assert (told["Ada"].count, told["Ben"].count) == (300, 60)
    assert told["Ada"].rate == pytest.approx(60.0, rel=0.1)
    assert told["Ada"].bars == {"jawOpen": 49 / 50}
    assert log.lines[-1].text == "Ada", "what goes on stands below what has ended"
    heard["Ben"] = 2
    source.look(9.0, log)
    assert [(line.text, line.count) for line in log.lines][-1] == ("Ben", 2), "it has come back"
