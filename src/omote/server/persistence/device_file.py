"""Keeps what pages have switched on, and tokens of other programs, beside a show file; its owner alone may read it."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import msgspec

from omote.interchange.formats.error_reasons import explain_error
from omote.server.persistence.private_file import write_private

MOST_BYTES = 65536


class DeviceNotes(msgspec.Struct, frozen=True):
    """What is kept. listen, send: words as after `--listen` and `--send`; tokens: by the program that granted each."""

    listen: tuple[str, ...] = ()
    send: tuple[str, ...] = ()
    tokens: dict[str, str] = {}


def device_path(show: Path) -> Path:
    """Where the notes of a show lie: beside its file, for a show that is mailed carries no tokens."""
    return show.with_name(show.name + ".devices")


def read_notes(path: Path) -> DeviceNotes:
    """The notes in a file, none where there is no file; OSError or ValueError with what to do."""
    try:
        with path.open("rb") as file:
            return msgspec.json.decode(file.read(MOST_BYTES), type=DeviceNotes)
    except FileNotFoundError:
        return DeviceNotes()
    except OSError as error:
        raise OSError(f"{path} cannot be read ({explain_error(error)}): make it readable, or delete it") from error
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise ValueError(f"{path} cannot be read ({explain_error(error)}): delete it") from error


def write_notes(path: Path, notes: DeviceNotes) -> None:
    """Writes the notes atomically, readable by their owner alone; OSError with a message.

    path: of the file; notes: all that it is to hold.
    """
    try:
        write_private(path, msgspec.json.format(msgspec.json.encode(notes), indent=2))
    except OSError as error:
        raise OSError(f"{path} cannot be written ({explain_error(error)})") from error


class DeviceFile:
    """The notes of a running show, written by a thread. path: None where nothing is kept; report: says what is wrong.
    notes: as they are now."""

    def __init__(self, path: Path | None, report: Callable[[str], None] = lambda _: None) -> None:
        self._path = path
        self._report = report
        self.notes = DeviceNotes()
        self._thread = ThreadPoolExecutor(1, "device file")  # it starts with the first change

    def load(self) -> None:
        """Reads the file; where it cannot be read that is said, and there are no notes."""
        try:
            self.notes = DeviceNotes() if self._path is None else read_notes(self._path)
        except (OSError, ValueError) as error:
            self._report(f"{error}.")

    def keep(self, **changed: object) -> None:
        """Changes some of the notes, and has them written; where that cannot be they hold until the end."""
        self.notes = msgspec.structs.replace(self.notes, **changed)
        if self._path is not None:
            self._thread.submit(self._write, self._path, self.notes)

    def token(self, program: str) -> str:
        """The token that a program has granted, or ""."""
        return self.notes.tokens.get(program, "")

    def keep_token(self, program: str, token: str) -> None:
        """Keeps a token; "" forgets it.

        program: its name; token: what it granted.
        """
        others = {name: kept for name, kept in self.notes.tokens.items() if name != program}
        self.keep(tokens={**others, program: token} if token else others)

    def close(self) -> None:
        """Waits until all is written."""
        self._thread.shutdown()

    def _write(self, path: Path, notes: DeviceNotes) -> None:
        try:
            write_notes(path, notes)
        except OSError as error:
            self._report(f"what is switched on at pages is not kept: {error}.")
