"""Recordings of behaviour: the same twice, and whatever changes is found where it is."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from omote.show.session import ShowSession
from tools.same import command
from tools.same.command import PARTS, compare, jobs, main
from tools.same.recording import Recording, compared
from tools.same.show_link import record_session


def show() -> Recording:
    recording = Recording()
    whole = Recording()
    record_session(recording)
    whole.add("wire", recording)
    return whole


def small(shift: float = 0.0) -> Recording:
    """Something of each part; shift: metres by which one position is off."""
    whole = Recording()
    for part in PARTS:
        recording = Recording()
        positions = np.arange(30, dtype=np.float32).reshape(-1, 3) / 100
        positions[0, 0] += shift if part == "stage" else 0.0
        recording.numbers("positions", "first", positions)
        recording.data("bytes", "first", b"\x00\x01")
        recording.sentence("first", "give a number from 0 to 1")
        whole.add(part, recording)
    return whole


def differing(before: Recording, after: Recording) -> list[str]:
    """The groups that differ."""
    groups = sorted(before.hashes.keys() | after.hashes.keys())
    return [each.group for each in compared(before, after, groups) if not each.same]


def test_a_show_is_recorded_the_same_twice() -> None:
    one = show()
    other = show()
    assert one.hashes == other.hashes
    assert len(one.hashes["wire: show: states"]) > 500
    assert differing(one, other) == []


def test_another_behaviour_is_found_where_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    before = show()
    clock = ShowSession.clock
    monkeypatch.setattr(ShowSession, "clock", lambda session, now: clock(session, now) + 1e-9)
    assert differing(before, show()) == ["wire: show: messages", "wire: show: wishes and names held"]


def test_a_reworded_refusal_shows_among_the_sentences_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    before = show()
    refuse = ShowSession._refuse
    monkeypatch.setattr(
        ShowSession,
        "_refuse",
        lambda session, who, refusal, *rest: refuse(session, who, type(refusal)(f"No: {refusal}"), *rest),
    )
    assert differing(before, show()) == ["wire: sentences"]


def test_a_moved_position_is_found_with_how_far_it_moved(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:  # fmt: skip
    before = tmp_path / "before.json"
    after = tmp_path / "after.json"
    small().write(before)
    small(2e-3).write(after)
    assert main(["compare", str(before), "--with", str(after)]) == 1
    said = capsys.readouterr().out
    assert "DIFFERS  stage: positions: 1 of 1 changed (first); greatest difference 2.000000 mm" in said
    assert "1 of 9 groups differ" in said
    assert main(["compare", str(before), "--with", str(after), "--no-browser"]) == 0
    assert "all 6 groups are the same" in capsys.readouterr().out


def test_a_recording_comes_back_from_its_files(tmp_path: Path) -> None:
    made = small()
    made.write(tmp_path / "made.json")
    read = Recording.read(tmp_path / "made.json")
    assert read.hashes == made.hashes
    assert read.samples.keys() == made.samples.keys()
    assert all(np.array_equal(read.samples[name], values) for name, values in made.samples.items())


@pytest.mark.parametrize("change", [b"\x00\x02", b"\x00\x01\x00", b""])
def test_a_changed_byte_is_found(change: bytes) -> None:
    before = Recording()
    after = Recording()
    before.data("bytes", "first", b"\x00\x01")
    after.data("bytes", "first", change)
    assert differing(before, after) == ["bytes"]


def test_what_is_missing_or_new_is_found() -> None:
    before = Recording()
    after = Recording()
    before.data("bytes", "old", b"")
    after.data("bytes", "new", b"")
    (difference,) = compared(before, after, ["bytes"])
    assert (difference.changed, difference.missing, difference.new) == ((), ("old",), ("new",))


def test_numbers_of_another_type_or_shape_are_others() -> None:
    hashes = set()
    for values in (
        np.zeros(4, np.float32),
        np.zeros((2, 2), np.float32),
        np.zeros(4, np.int32),
        np.zeros(2, np.float64),
    ):
        recording = Recording()
        recording.numbers("numbers", "first", values)
        hashes.add(recording.hashes["numbers"]["first"])
    assert len(hashes) == 4


def test_a_key_is_recorded_once() -> None:
    recording = small()
    with pytest.raises(ValueError, match="twice"):
        recording.data("wire: bytes", "first", b"")
    with pytest.raises(ValueError, match="twice"):
        recording.add("wire", Recording({"bytes": {"first": ""}}))


def test_an_error_is_recorded_apart_from_its_words() -> None:
    recording = Recording()
    with recording.refusal("refused", "number"):
        float("seven")
    with recording.refusal("refused", "nothing"):
        pass
    assert recording.hashes["refused"]["number"] != recording.hashes["refused"]["nothing"]
    assert [*recording.hashes["sentences"]] == ["refused: number"]


def test_parts_are_chosen_by_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert {job.part for job in jobs(["kaori"], PARTS)} == set(PARTS)
    asked: list[list[str]] = []

    def record(parts: list[str]) -> Recording:
        asked.append(parts)
        return Recording()

    monkeypatch.setattr(command, "record", record)
    assert main(["record", str(tmp_path / "a.json"), "--only", "wire,stage", "--no-browser"]) == 0
    assert asked == [["wire"]]
    with pytest.raises(SystemExit):
        main(["record", str(tmp_path / "a.json"), "--only", "wires"])


def test_nothing_compared_with_nothing_is_no_proof(capsys: pytest.CaptureFixture[str]) -> None:
    assert not compare(Recording(), Recording())
    assert "nothing" in capsys.readouterr().out
