"""The log of inputs: bounded, the same once, whatever comes."""

from omote.inputs.page_devices.input_log import LINES_A_SECOND, MOST_LINES, LineLog


def test_the_same_within_a_second_is_one_line() -> None:
    log = LineLog(started=1000.0)
    for n in range(50):
        log.note("pad", "no such face", n / 100, rejected=True)
    (line,) = log.lines
    assert (line.text, line.count, line.rejected, line.time) == ("no such face", 50, True, 1000.0)
    log.note("pad", "no such face", 2.0, rejected=True)
    assert [line.count for line in log.lines] == [50, 1]


def test_a_flood_makes_a_few_lines_a_second_and_none_of_another_source_is_lost() -> None:
    log = LineLog()
    for n in range(40_000):
        log.note("OSC", f"message {n}", n / 40_000)
    log.note("pad", "1/cc7 0.5", 1.0)
    assert [line.source for line in log.lines].count("OSC") == LINES_A_SECOND
    assert sum(line.count for line in log.lines if line.source == "OSC") == 40_000
    assert log.lines[-1].source == "pad"
    assert "message 39999, among others" in [line.text for line in log.lines]


def test_it_stays_bounded_and_each_change_has_a_number() -> None:
    log = LineLog()
    numbers = set()
    for n in range(3 * MOST_LINES):
        log.note(f"pad {n % 7}", "x" * 10_000, float(n))
        numbers.add(log.number)
    assert len(log.lines) == MOST_LINES
    assert len(numbers) == 3 * MOST_LINES
    assert max(len(line.text) for line in log.lines) <= 300


def test_what_comes_without_end_is_one_line_until_nothing_comes() -> None:
    log = LineLog()
    numbers = set()
    for n in range(100):
        log.follow("VMC", "Ada", n / 10, count=6, rate=60.0, bars={"jawOpen": n / 100})
        numbers.add(log.number)
    log.note("pad", "1/cc7 0.5", 9.95)
    log.follow("VMC", "Ada", 10.0, count=6, rate=60.0, bars={"jawOpen": 1.0})
    assert [(line.source, line.count, line.bars) for line in log.lines] == [
        ("pad", 1, {}), ("VMC", 606, {"jawOpen": 1.0}),
    ]  # fmt: skip
    assert len(numbers) == 100
    log.follow("VMC", "Ada", 12.0, count=6, rate=60.0, bars={"jawOpen": 1.0})
    assert [line.count for line in log.lines if line.source == "VMC"] == [606, 6]
