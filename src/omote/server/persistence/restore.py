"""Brings a show back from its file: nothing in the file can keep the show from starting."""

from __future__ import annotations

import math
import sqlite3
import time
from collections.abc import Callable
from pathlib import Path

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.perform.limits import GAZE_LIMITS
from omote.perform.scene.character_names import FIRST_CHARACTER
from omote.perform.snapshot import Playable
from omote.server.process.process_messages import Failover, Order
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.showfile.backup import backup_paths
from omote.showfile.database_errors import explain_database_error
from omote.showfile.identification import ForeignFileError, identify, locate_show
from omote.showfile.recovery import Recovery, is_lost, recover_show
from omote.showfile.show_file import CorruptShowFileError, JournalEntry, ShowFile, ShowFileError, open_show

Report = Callable[[str], None]

FIRST_LIVELINESS = 0.5
"""How much the character of a new show moves by itself: as people do."""
FRESH_SECONDS = 3.0
"""A state that is not older is what was on air: a resting show writes one a second."""


def open_journal(path: Path, report: Report) -> ShowFile | None:
    """The show file, or its newest whole backup (`open_newest`); None when the disk allows no file at all.

    path: of the show file; report: tells the operator.
    """
    try:
        return open_newest(path, report)
    except (ShowFileError, OSError) as error:
        report(f"{explain_database_error(error)} The show goes on, but nothing of it is kept.")
        return None


def open_newest(path: Path, report: Report) -> ShowFile:
    """The show file, made when there is none; a corrupt or lost one is kept and its newest whole backup opened.

    ShowFileError with an error message where it cannot be used; then it is untouched.

    path: of the show file; report: tells the operator.
    """
    path = locate_show(path)
    try:
        try:
            if is_lost(path):
                raise CorruptShowFileError(f"{path} is {'empty' if path.exists() else 'not there'}.")
            return open_show(path)
        except CorruptShowFileError as error:
            report(f"{error} {_sentence_of(recover_show(path))}")
            return open_show(path)
    except ForeignFileError as error:
        raise ForeignFileError(f"{error}{_backup_beside(path)}") from error
    except (sqlite3.Error, OSError) as error:
        raise ShowFileError(
            f"{path} cannot be used ({explain_database_error(error)}): mend that, or name another file."
        ) from error


def _backup_beside(path: Path) -> str:
    """What to do where somebody else's file has the name of a show whose backups are still there."""
    backups = [backup for backup in backup_paths(path) if backup.is_file() and identify(backup).kind == "show"]
    if not backups:
        return ""
    return f" A good copy of a show lies beside it, {backups[0].name}: move {path.name} away, and its copy is opened."


def _sentence_of(recovery: Recovery) -> str:
    kept = "" if recovery.kept is None else f"it is kept as {recovery.kept}; "
    if recovery.copied is None:
        return _sentence(f"{kept}there is no good copy of it: the show starts neutral.")
    copied_at = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(recovery.copied))
    return _sentence(f"{kept}opened instead: its good copy of {copied_at}.")


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:]


def restore(cast: Playable, show: ShowFile | None, order: Order, report: Report) -> ShowSession:
    """The session of the journal's last state, under a new epoch; a neutral one when none can be played.

    The character of a new show blinks and breathes; one that begins neutral after a fault holds still.

    cast: what can be played; show: the open file, if any; order: of the supervisor; report: tells the operator.
    """
    last = _last_entry(show, report)
    epoch = next_epoch(last.epoch, order.epoch)
    session = None if order.neutral else _try_restore(cast, last, epoch, report)
    if order.failover is not None:
        written = None if session is None else last.written
        report(_failover_sentence(order, order.failover, written, now=time.monotonic()))
    aside = None if session is not None else last
    if session is None:
        session = ShowSession(cast, epoch=epoch)
        if last.snapshot is None and not order.neutral and order.failover is None:
            session.scene[FIRST_CHARACTER].set_motion(FIRST_LIVELINESS)
    session.show = _identify(show)
    _record(show, session, aside, report)
    return session


def _identify(show: ShowFile | None) -> str:
    """Which show is played; "" where none can be read: then pages take up nothing that they kept."""
    try:
        return "" if show is None else show.identity()
    except sqlite3.Error:
        return ""


def _failover_sentence(order: Order, failover: Failover, written: float | None, *, now: float) -> str:
    """When the process before ended, how long nothing was sent, and what was on air then.

    written: when what is restored was on air; None where the show starts neutral. The sentence stays on consoles, so
    it says what was, not what is.
    """
    seconds = now - failover.ended
    wall = time.time() - seconds  # noqa: TID251  (for people to read; drives nothing)
    how = "stopped answering" if failover.hung else "ended"
    at = time.strftime("%H:%M:%S", time.localtime(wall))
    pause = "less than 0.1 s" if seconds < 0.1 else f"{seconds:.1f} s"
    if written is None:
        why = ", because processes kept ending on its last state" if order.neutral else ""
        what = f"the show started neutral{why}"
    else:
        what = _resumed(failover.ended - written)
    times = f" This was the {ordinal(failover.count)} time in this show." if failover.count > 1 else ""
    return f"the show's process {how} at {at} and was started again after {pause}; {what}.{times}"


def _resumed(age: float) -> str:
    """What went on: a state that was written so many seconds before the end, by the clock of this start of the machine.

    While the process before still played it may have written a state after its last sign of life.
    """
    if abs(age) <= FRESH_SECONDS:
        return "what was on air went on"
    when = f"{age:.0f} s before" if age > 0 else "earlier"
    return f"nothing newer was left than what was on air {when}, and that went on"


def ordinal(number: int) -> str:
    """`3` as "3rd"."""
    ending = "th" if number % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number}{ending}"


def journal_entry(session: ShowSession) -> JournalEntry:
    """The session as it is now, for the journal."""
    return JournalEntry(session.epoch, time.monotonic(), msgspec.msgpack.encode(session.snapshot()))


def next_epoch(journal: int, order: int) -> int:
    """An epoch above all before it: of this file, of this supervisor, and, by the calendar, of other show files.

    journal: the last epoch of the file; order: the least that the supervisor asks for.
    """
    return max(journal + 1, order, int(time.time()))  # noqa: TID251  (orders starts of servers; drives nothing)


def _last_entry(show: ShowFile | None, report: Report) -> JournalEntry:
    try:
        return show.journal() if show else JournalEntry(0, 0.0, None)
    except sqlite3.Error as error:
        report(
            f"the last state cannot be read from the show file ({explain_database_error(error)}); the show starts "
            "neutral."
        )
        return JournalEntry(0, 0.0, None)


def _record(show: ShowFile | None, session: ShowSession, aside: JournalEntry | None, report: Report) -> None:
    """Puts the new epoch into the journal, and a last state that is not played on aside."""
    if show is None:
        return
    try:
        if aside is not None:
            show.set_aside(aside, "not played on: it could not be, or the servers that started from it died")
        show.write_journal(journal_entry(session))
    except sqlite3.Error as error:
        report(f"the state cannot be written to the show file ({explain_database_error(error)}); the show goes on.")


def _try_restore(cast: Playable, entry: JournalEntry, epoch: int, report: Report) -> ShowSession | None:
    if entry.snapshot is None:
        return None
    try:
        saved = msgspec.msgpack.decode(entry.snapshot)
        snapshot, limited = read_session_snapshot(saved)
        session = ShowSession.restored(cast, snapshot, epoch=epoch)
    except (ValueError, TypeError, RecursionError) as error:
        report(
            f"the last state cannot be played ({explain_error(error)}); it is kept aside and the show starts neutral."
        )
        return None
    if limited:
        reach = "{:.0f} degrees sideways, {:.0f} up or down".format(*map(math.degrees, GAZE_LIMITS.values()))
        report(f"the gaze was farther than eyes turn: it is brought to {reach}.")
    return session
