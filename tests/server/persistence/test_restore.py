"""Whatever the show file holds, the show starts."""

import os
import re
import shutil
import sqlite3
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from omote.model.cast import Cast
from omote.perform.frame import Gaze
from omote.perform.limits import GAZE_LIMITS
from omote.server.persistence.restore import journal_entry, next_epoch, open_journal, open_newest, ordinal, restore
from omote.server.process.process_messages import Failover, Order
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello, Welcome
from omote.show.session import ShowSession
from omote.showfile.backup import back_up, backup_paths
from omote.showfile.changes import StoredDocument
from omote.showfile.identification import ForeignFileError
from omote.showfile.schema import SCHEMA_VERSION
from omote.showfile.show_file import JournalEntry, ShowFile, open_show

ORDER = Order(epoch=1, neutral=False)


@dataclass
class Terminal:
    """Keeps what is said."""

    said: list[str] = field(default_factory=list)

    def __call__(self, sentence: str) -> None:
        self.said.append(sentence)


@pytest.fixture
def report() -> Terminal:
    """An operator's terminal."""
    return Terminal()


def kept(path: Path, cast: Cast) -> ShowFile:
    """A show file whose journal says that the mouth is open."""
    session = ShowSession(cast, epoch=5)
    session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
    session.receive("a", SetChannel("one", "jawOpen", 0.5), 0.0)
    show = open_show(path)
    show.write_journal(journal_entry(session))
    return show


def test_a_show_goes_on_under_a_higher_epoch(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = kept(tmp_path / "a.omote", cast)
    session = restore(cast, show, ORDER, report)
    assert session.tick(0.0).characters["one"].channels == {"jawOpen": 0.5}
    assert session.epoch > 5
    assert show.journal().epoch == session.epoch
    assert restore(cast, show, ORDER, report).epoch > session.epoch
    assert report.said == []
    show.close()


def test_consoles_are_told_which_show_it_is(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    def told(show: ShowFile | None) -> str:
        session = restore(cast, show, ORDER, report)
        welcome = session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)[0]
        assert isinstance(welcome.message, Welcome)
        return welcome.message.show

    first, second = (open_show(tmp_path / name) for name in ("a.omote", "b.omote"))
    assert told(first) == told(first) == first.identity() != second.identity() == told(second)
    assert told(None) == ""
    second._connection.execute("DROP TABLE identity")
    assert told(second) == ""
    first.close()
    second.close()


def test_a_new_file_starts_neutral(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = open_show(tmp_path / "a.omote")
    session = restore(cast, show, ORDER, report)
    assert session.tick(0.0).characters["one"].faces == {"generic": 1.0}
    assert show.journal().epoch == session.epoch
    assert report.said == []
    show.close()


def test_a_new_show_blinks_and_breathes(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = open_show(tmp_path / "a.omote")
    session = restore(cast, show, ORDER, report)
    assert set(session.tick(0.0).characters["one"].layers) >= {"blink", "breath", "gaze"}
    assert len({session.tick(seconds).characters["one"].eyes for seconds in (1.0, 3.0, 5.0, 7.0)}) > 1
    session.scene["one"].set_motion(0.0)
    show.write_journal(journal_entry(session))
    assert lively(restore(cast, show, ORDER, report)) == 0.0
    assert lively(restore(cast, None, ORDER, report)) == 0.5
    show.close()


def test_what_begins_neutral_after_a_fault_holds_still(cast: Cast, report: Terminal) -> None:
    assert lively(restore(cast, None, Order(epoch=1, neutral=True), report)) == 0.0
    assert lively(restore(cast, None, Order(1, neutral=False, failover=Failover(1, 0.0, hung=False)), report)) == 0.0


def test_a_show_of_before_keeps_its_stillness(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = kept(tmp_path / "a.omote", cast)
    assert lively(restore(cast, show, ORDER, report)) == 0.0
    show.close()


def lively(session: ShowSession) -> float:
    """How much the first character moves by itself."""
    motion = session.tick(0.0).characters["one"].motion
    return 0.0 if motion is None else motion.liveliness


def test_a_suspected_state_is_kept_aside(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = kept(tmp_path / "a.omote", cast)
    snapshot = show.journal().snapshot
    session = restore(cast, show, Order(epoch=1, neutral=True), report)
    assert session.tick(0.0).characters["one"].channels == {}
    assert aside(tmp_path / "a.omote") == [(5, snapshot)]
    show.close()


@given(snapshot=st.binary(max_size=60))
@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
def test_a_state_that_is_none_is_kept_aside_and_said(tmp_path: Path, cast: Cast, snapshot: bytes) -> None:
    (tmp_path / "a.omote").unlink(missing_ok=True)
    report = Terminal()
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(9, 0.0, snapshot))
    session = restore(cast, show, ORDER, report)
    assert session.tick(0.0).characters["one"].faces == {"generic": 1.0}
    assert session.epoch > 9
    assert len(report.said) == 1
    assert "starts neutral" in report.said[0]
    assert aside(tmp_path / "a.omote") == [(9, snapshot)]
    show.close()


def test_a_face_that_is_gone_from_the_cast_does_not_stop_the_show(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    session = ShowSession(cast)
    session.scene["one"].call_face("broad", seconds=1.0)
    session.tick(0.0)
    data = msgspec.msgpack.encode(session.snapshot()).replace(b"broad", b"cause")
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(1, 0.0, data))
    assert restore(cast, show, ORDER, report).tick(0.0).characters["one"].faces == {"generic": 1.0}
    assert "'cause'" in report.said[0]
    show.close()


def test_a_gaze_of_before_its_range_opens_and_is_told(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = kept(tmp_path / "a.omote", cast)
    saved = msgspec.msgpack.decode(show.journal().snapshot or b"")
    saved = {"performer": saved["scene"]["characters"]["one"]["performer"], "calls": ["a-1"]}
    saved["performer"]["gaze"] = {"yaw": -1.2, "pitch": 0.1}
    show.write_journal(JournalEntry(5, 0.0, msgspec.msgpack.encode(saved)))
    session = restore(cast, show, ORDER, report)
    assert session.tick(0.0).characters["one"].channels == {"jawOpen": 0.5}
    assert session.scene["one"].snapshot().gaze == Gaze(-GAZE_LIMITS["yaw"], 0.1)
    assert report.said == ["the gaze was farther than eyes turn: it is brought to 40 degrees sideways, 30 up or down."]
    assert aside(tmp_path / "a.omote") == []
    show.close()


def test_a_corrupt_file_is_kept_and_a_new_one_made(tmp_path: Path, report: Terminal) -> None:
    open_show(tmp_path / "a.omote").close()
    damaged = (tmp_path / "a.omote").read_bytes()[:5000]
    (tmp_path / "a.omote").write_bytes(damaged)
    show = open_journal(tmp_path / "a.omote", report)
    assert show is not None
    assert (tmp_path / "a.omote.corrupt-1").read_bytes() == damaged
    assert str(tmp_path / "a.omote.corrupt-1") in report.said[0]
    show.close()


@dataclass(frozen=True)
class Before:
    """A show file as a killed server left it, and which layouts its newest backup, itself, and it with its log hold."""

    files: dict[str, bytes]
    copied: set[str]
    flushed: set[str]
    all: set[str]


@pytest.fixture(scope="module")
def before(tmp_path_factory: pytest.TempPathFactory) -> Before:
    """Ten pages of layouts; half of them in the newest backup, the last in the log only."""
    show = open_show(tmp_path_factory.mktemp("show") / "a.omote")
    for number in range(10):
        show.apply([StoredDocument("layout", f"page {number}", bytes([65 + number]) * 3000)])
        if number in (1, 4):
            back_up(show)
            copied = set(show.stored().documents.get("layout", {}))
        if number == 8:
            show.flush()
            flushed = set(show.stored().documents.get("layout", {}))
    show.write_journal(JournalEntry(1234, 5.0, b"state"))
    paths = (path for path in show.path.parent.iterdir() if not path.name.endswith("-shm"))
    files = {path.name: path.read_bytes() for path in paths}
    everything = set(show.stored().documents.get("layout", {}))
    show.close()
    return Before(files, copied, flushed, everything)


def started(folder: Path, before: Before, damaged: bytes, *, log: bool) -> set[str]:
    """Starts twice with a damaged file; which layouts there are then. A corrupt file is kept, the second start is
    silent."""
    files = before.files | {"a.omote": damaged}
    for name in files if log else files.keys() - {"a.omote-wal"}:
        (folder / name).write_bytes(files[name])
    report = Terminal()
    again = Terminal()
    show = open_newest(folder / "a.omote", report)
    stored = show.stored()
    show.close()
    if report.said:
        assert len(report.said) == 1
        assert (folder / "a.omote.corrupt-1").read_bytes() == damaged
    second = open_newest(folder / "a.omote", again)
    assert second.stored() == stored
    second.close()
    assert again.said == []
    assert len([*folder.glob("*.corrupt-?")]) == len(report.said)
    assert all(
        document == bytes([65 + int(name[5:])]) * 3000 for name, document in stored.documents.get("layout", {}).items()
    )
    shutil.rmtree(folder)
    return set(stored.documents.get("layout", {}))


@pytest.mark.parametrize("log", [True, False], ids=["with its log", "without its log"])
def test_a_file_cut_anywhere_opens_its_newest_backup(tmp_path: Path, before: Before, log: bool) -> None:
    whole = before.files["a.omote"]
    for length in [*range(0, len(whole), 3 * 4096), *range(1, len(whole), 7777), 99, 100, 511, 512]:
        (tmp_path / "cut").mkdir()
        found = started(tmp_path / "cut", before, whole[:length], log=log)
        assert found in (before.copied, before.all if log else before.flushed), f"cut to {length} bytes"
    (tmp_path / "cut").mkdir()
    assert started(tmp_path / "cut", before, whole, log=True) == before.all


@pytest.mark.parametrize("block", [b"\xa5" * 4096, bytes(4096), b"\xff" * 512])
def test_a_file_written_over_anywhere_opens_its_newest_backup(
    tmp_path: Path, before: Before, block: bytes
) -> None:  # fmt: skip
    whole = before.files["a.omote"]
    for start in range(0, len(whole), 7000):
        (tmp_path / "over").mkdir()
        damaged = (whole[:start] + block + whole[start + len(block) :])[: len(whole)]
        found = started(tmp_path / "over", before, damaged, log=False)
        assert found in (before.copied, before.flushed), f"from byte {start}"


def test_it_is_said_what_was_opened_instead(tmp_path: Path, report: Terminal) -> None:
    show = open_show(tmp_path / "a.omote")
    show.apply([StoredDocument("layout", "early", b"{}")])
    back_up(show)
    show.apply([StoredDocument("layout", "late", b"{}")])
    show.close()
    damaged = bytes(4096) + show.path.read_bytes()[4096:]
    show.path.write_bytes(damaged)
    os.utime(backup_paths(show.path)[0], (0.0, 0.0))
    opened = open_newest(show.path, report)
    assert set(opened.stored().documents.get("layout", {})) == {"early"}
    opened.close()
    made = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(0.0))
    assert report.said[0].endswith(f"a.omote.corrupt-1; opened instead: its good copy of {made}.")


def test_a_lost_file_is_said(tmp_path: Path, report: Terminal) -> None:
    show = open_show(tmp_path / "a.omote")
    show.apply([StoredDocument("layout", "early", b"{}")])
    back_up(show)
    show.close()
    show.path.unlink()
    opened = open_newest(show.path, report)
    assert set(opened.stored().documents.get("layout", {})) == {"early"}
    opened.close()
    assert "a.omote is not there. Opened instead: its good copy of" in report.said[0]


def test_a_disk_that_takes_no_recovery_leaves_the_corrupt_file(
    tmp_path: Path, report: Terminal, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError("No space left on device")

    open_show(backup_paths(tmp_path / "a.omote")[0]).close()
    (tmp_path / "a.omote").write_bytes(bytes(5000))
    monkeypatch.setattr("omote.showfile.recovery.shutil.copyfile", full)
    assert open_journal(tmp_path / "a.omote", report) is None
    assert "No space left on device" in report.said[-1]
    assert (tmp_path / "a.omote").read_bytes() == bytes(5000)


def test_a_file_of_a_newer_version_is_left_alone(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    open_show(tmp_path / "a.omote").close()
    connection = sqlite3.connect(tmp_path / "a.omote")
    connection.execute(f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    connection.close()
    before = (tmp_path / "a.omote").read_bytes()
    assert open_journal(tmp_path / "a.omote", report) is None
    assert "update Omote. The show goes on, but nothing of it is kept." in report.said[0]
    assert (tmp_path / "a.omote").read_bytes() == before
    assert restore(cast, None, ORDER, report).tick(0.0).number == 1


def test_an_epoch_out_of_range_does_not_stop_the_show(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = open_show(tmp_path / "a.omote")
    show.write_journal(JournalEntry(2**63 - 1, 0.0, b"state"))
    assert restore(cast, show, ORDER, report).epoch < 2**53
    assert "its epoch 9223372036854775807 was written by no server" in report.said[0]
    show.close()


def test_a_disk_that_fails_at_the_start_does_not_stop_the_show(tmp_path: Path, cast: Cast, report: Terminal) -> None:
    show = kept(tmp_path / "a.omote", cast)
    show.close()  # every use of it fails from here on
    assert restore(cast, show, ORDER, report).tick(0.0).characters["one"].faces == {"generic": 1.0}
    assert [word in said for word, said in zip(("read", "written"), report.said, strict=True)] == [True, True]


@given(journal=st.integers(0, 2**52), order=st.integers(0, 2**52))
def test_an_epoch_is_above_all_before_it(journal: int, order: int) -> None:
    assert next_epoch(journal, order) > journal
    assert next_epoch(journal, order) >= order
    assert next_epoch(0, 0) > 1_700_000_000  # above the epochs of other files, by the calendar


def aside(path: Path) -> list[tuple[int, bytes]]:
    """What is kept aside in a show file."""
    connection = sqlite3.connect(path)
    rows: list[tuple[int, bytes]] = connection.execute("SELECT epoch, snapshot FROM journal_aside").fetchall()
    connection.close()
    return rows


@pytest.mark.parametrize("hung", [True, False])
@pytest.mark.parametrize("count", [1, 2])
def test_after_a_failover_it_is_said_when_for_how_long_and_what_is_on_air(
    tmp_path: Path, cast: Cast, report: Terminal, hung: bool, count: int
) -> None:
    show = kept(tmp_path / "a.omote", cast)
    ended = time.monotonic() - 2.0
    show.write_journal(replace(show.journal(), written=ended - 1.0))
    before = time.time_ns() / 1e9 - 2.0
    restore(cast, show, Order(1, neutral=False, failover=Failover(count, ended, hung)), report)
    (said,) = report.said
    assert f"the show's process {'stopped answering' if hung else 'ended'} at " in said
    at = re.search(r" at (\d\d:\d\d:\d\d) and was started again after (\d+\.\d) s; what was on air went on\.", said)
    assert at is not None
    assert float(at[2]) >= 2.0
    assert at[1] in {time.strftime("%H:%M:%S", time.localtime(before + late)) for late in range(60)}
    assert ("2nd time in this show" in said) == (count == 2)
    show.close()


@pytest.mark.parametrize("age", [5.0, 24.0, -1e6])
def test_after_a_failover_it_is_said_that_only_an_old_state_was_there(
    tmp_path: Path, cast: Cast, report: Terminal, age: float
) -> None:
    """A backup's, for example; of one that was written before the machine was started nobody knows the age."""
    show = kept(tmp_path / "a.omote", cast)
    ended = time.monotonic()
    show.write_journal(replace(show.journal(), written=ended - age))
    restore(cast, show, Order(1, neutral=False, failover=Failover(1, ended, hung=False)), report)
    when = f"{age:.0f} s before" if age > 0 else "earlier"
    assert f"; nothing newer was left than what was on air {when}, and that went on." in report.said[0]
    show.close()


def test_after_a_failover_without_a_state_it_is_said_that_the_show_starts_neutral(
    tmp_path: Path, cast: Cast, report: Terminal
) -> None:
    show = kept(tmp_path / "a.omote", cast)
    failover = Failover(3, time.monotonic(), hung=False)
    restore(cast, show, Order(1, neutral=True, failover=failover), report)
    restore(cast, None, Order(1, neutral=False, failover=failover), report)
    assert "the show started neutral, because processes kept ending on its last state. This" in report.said[0]
    assert "; the show started neutral. This was the 3rd" in report.said[1]
    show.close()


@pytest.mark.parametrize(
    ("number", "word"), [(1, "1st"), (2, "2nd"), (3, "3rd"), (4, "4th"), (11, "11th"), (112, "112th"), (23, "23rd")]
)
def test_ordinals(number: int, word: str) -> None:
    assert ordinal(number) == word


def test_somebody_else_s_file_in_a_show_s_place_stays_and_its_backup_is_named(tmp_path: Path, report: Terminal) -> None:
    path = tmp_path / "a.omote"
    show = open_show(path)
    show.apply([StoredDocument("layout", "early", b"{}")])
    back_up(show)
    show.close()
    path.write_text("milk and eggs")
    with pytest.raises(ForeignFileError, match=r"lies beside it, a\.omote\.good: move a\.omote away"):
        open_newest(path, report)
    assert path.read_text() == "milk and eggs"
    path.rename(tmp_path / "notes.txt")
    opened = open_newest(path, report)
    assert set(opened.stored().documents.get("layout", {})) == {"early"}
    opened.close()
