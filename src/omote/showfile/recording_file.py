"""The recording beside a show file: one SQLite file (`NAME.omote-recording`) with what the show did, minute by minute.

A piece is a minute: it is added to, a second at a time, until it is packed; it needs no other. The ring is the pieces
of the last 100 minutes; older ones go, but those of a recording that was kept by its name. In WAL mode every second
that was added survives the death of the process.
"""

from __future__ import annotations

import sqlite3
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from omote.showfile.database_errors import explain_database_error
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import make_private

APPLICATION_ID = 0x4F4D4F52  # "OMOR"
VERSION = 1
RING_SECONDS = 6000.0
"""100 minutes: a night."""
SUFFIX = "-recording"
BUSY_SECONDS = 5.0
MOST_NAME = 80
_SCHEMA = """
CREATE TABLE start (
    id INTEGER PRIMARY KEY,
    written REAL NOT NULL,
    clock REAL NOT NULL,
    program TEXT NOT NULL
) STRICT;
CREATE TABLE piece (
    id INTEGER PRIMARY KEY,
    start INTEGER NOT NULL REFERENCES start (id),
    first REAL NOT NULL,
    last REAL NOT NULL,
    ticks INTEGER NOT NULL,
    casts TEXT NOT NULL,
    packed BLOB
) STRICT;
CREATE TABLE second (
    id INTEGER PRIMARY KEY,
    piece INTEGER NOT NULL REFERENCES piece (id) ON DELETE CASCADE,
    data BLOB NOT NULL
) STRICT;
CREATE INDEX seconds_of_pieces ON second (piece);
CREATE TABLE "cast" (
    digest TEXT PRIMARY KEY,
    base TEXT NOT NULL,
    own BLOB NOT NULL,
    contents TEXT NOT NULL
) STRICT;
CREATE TABLE content (
    key TEXT PRIMARY KEY,
    data BLOB NOT NULL
) STRICT;
CREATE TABLE marker (
    id INTEGER PRIMARY KEY,
    piece INTEGER NOT NULL REFERENCES piece (id) ON DELETE CASCADE,
    at REAL NOT NULL,
    name TEXT NOT NULL,
    who TEXT NOT NULL
) STRICT;
CREATE TABLE kept (
    name TEXT PRIMARY KEY,
    start INTEGER NOT NULL,
    first REAL NOT NULL,
    last REAL NOT NULL
) STRICT;
"""


@dataclass(frozen=True)
class StoredCast:
    """A cast that was played: base, the digest of the built-in cast; own, the items beside it, as bytes; contents: the
    keys of their contents."""

    digest: str
    base: str
    own: bytes
    contents: tuple[str, ...]


@dataclass(frozen=True)
class Piece:
    """A minute of a recording. start: which start of the show it is of; first, last: seconds of the machine's clock;
    ticks: how many; written: when it began, seconds since 1970; program: which version recorded it."""

    id: int
    start: int
    first: float
    last: float
    ticks: int
    written: float
    program: str


@dataclass(frozen=True)
class Marker:
    """A moment that somebody marked. start, at: when, as of `Piece`; name: what it is called; who: marked it."""

    start: int
    at: float
    name: str
    who: str


@dataclass(frozen=True)
class KeptRecording:
    """A recording that stays: from `first` to `last`, seconds of the machine's clock, of one start of the show."""

    name: str
    start: int
    first: float
    last: float


def recording_path(show: Path) -> Path:
    """Where the recording of a show file lies. show: the path of that."""
    return show.with_name(show.name + SUFFIX)


def sound_key(sound: str) -> str:
    """Under which key a recording keeps a sound. sound: its key in the show."""
    return f"sound-{sound}"


class RecordingFile:
    """An open recording; made by `open_recording`."""

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        self._connection = connection
        self.path = path

    # --- what is written while a show plays ---

    def begin_start(self, written: float, clock: float, program: str) -> int:
        """Begins a start of the show and returns its id. written: seconds since 1970; clock: seconds, monotonic, then;
        program: its version."""
        with self._connection:
            row = self._connection.execute(
                "INSERT INTO start (written, clock, program) VALUES (?, ?, ?)", (written, clock, program)
            )
        return int(row.lastrowid or 0)

    def begin_piece(self, start: int, first: float) -> int:
        """Begins a piece and returns its id. start: of the show; first: seconds, monotonic."""
        with self._connection:
            row = self._connection.execute(
                "INSERT INTO piece (start, first, last, ticks, casts) VALUES (?, ?, ?, 0, '')", (start, first, first)
            )
        return int(row.lastrowid or 0)

    def add(
        self, piece: int, data: bytes, *, last: float, ticks: int, casts: Iterable[str] = (),
        markers: Sequence[tuple[float, str, str]] = (),
    ) -> None:  # fmt: skip
        """Adds about a second to a piece.

        Parameters
        ----------
        piece : int
            Its id.
        data : bytes
            What happened.
        last : float
            Seconds, monotonic, of the last tick.
        ticks : int
            How many.
        casts : iterable of str
            The digests of all casts that the piece has played, and the keys of clips and sounds.
        markers : sequence of (float, str, str)
            When, what and who.
        """
        with self._connection:
            self._connection.execute("INSERT INTO second (piece, data) VALUES (?, ?)", (piece, data))
            self._connection.execute(
                "UPDATE piece SET last = ?, ticks = ticks + ?, casts = ? WHERE id = ?",
                (last, ticks, " ".join(casts), piece),
            )
            self._connection.executemany(
                "INSERT INTO marker (piece, at, name, who) VALUES (?, ?, ?, ?)",
                [(piece, *marker) for marker in markers],
            )

    def pack(self, piece: int, packed: bytes) -> None:
        """Keeps a piece that nothing is added to any more as `packed` has it, in the place of its seconds."""
        with self._connection:
            self._connection.execute("UPDATE piece SET packed = ? WHERE id = ?", (packed, piece))
            self._connection.execute("DELETE FROM second WHERE piece = ?", (piece,))

    def unpacked(self) -> list[int]:
        """The ids of the pieces that are not packed: the last one, and that of a process that died."""
        return [int(row[0]) for row in self._connection.execute("SELECT id FROM piece WHERE packed IS NULL")]

    def keep_cast(self, cast: StoredCast, contents: Iterable[tuple[str, bytes]]) -> None:
        """Keeps a cast with the contents of its own items, by key, that are not kept yet."""
        with self._connection:
            self._connection.execute(
                'INSERT OR IGNORE INTO "cast" VALUES (?, ?, ?, ?)',
                (cast.digest, cast.base, cast.own, " ".join(cast.contents)),
            )
            self._connection.executemany("INSERT OR IGNORE INTO content VALUES (?, ?)", contents)

    def keep_content(self, key: str, data: bytes) -> None:
        """Keeps a clip or a sound that a piece names among its casts, where it is not kept yet. key: of it; data: its
        bytes."""
        with self._connection:
            self._connection.execute("INSERT OR IGNORE INTO content VALUES (?, ?)", (key, data))

    def trim(self, seconds: float = RING_SECONDS) -> set[str]:
        """Removes pieces that are older than so many seconds of playing, but those of kept recordings, and the casts
        that none plays any more; returns the keys of the contents that went with them."""
        pieces = self.pieces()
        left = seconds
        gone: list[int] = []
        kept = self.kept()
        for piece in reversed(pieces):
            wanted = any(
                each.start == piece.start and each.first <= piece.last and piece.first <= each.last for each in kept
            )
            if left <= 0.0 and not wanted:
                gone.append(piece.id)
            left -= piece.last - piece.first
        if not gone:
            return set()
        with self._connection:
            self._connection.executemany("DELETE FROM piece WHERE id = ?", [(number,) for number in gone])
            self._connection.execute("DELETE FROM start WHERE id NOT IN (SELECT start FROM piece)")
            return self._forget_unplayed()

    def _forget_unplayed(self) -> set[str]:
        """Removes the casts that no piece plays, and the contents that no cast has; returns the keys of these."""
        played = {
            digest for (casts,) in self._connection.execute("SELECT casts FROM piece") for digest in casts.split()
        }
        rows = self._connection.execute('SELECT digest, contents FROM "cast"').fetchall()
        unplayed = [(digest,) for digest, _ in rows if digest not in played]
        self._connection.executemany('DELETE FROM "cast" WHERE digest = ?', unplayed)
        needed = played | {key for digest, contents in rows if digest in played for key in contents.split()}
        keys = {str(key) for (key,) in self._connection.execute("SELECT key FROM content")} - needed
        self._connection.executemany("DELETE FROM content WHERE key = ?", [(key,) for key in keys])
        return keys

    # --- what is kept and read ---

    def keep(self, recording: KeptRecording) -> None:
        """Keeps a recording under its name; ValueError where the name is taken, or nothing was recorded then."""
        if not 0 < len(recording.name.strip()) <= MOST_NAME:
            raise ValueError(f"a recording cannot be called {recording.name!r:.100}; give 1 to {MOST_NAME} letters")
        if any(each.name == recording.name for each in self.kept()):
            raise ValueError(f"there is a recording {recording.name!r} already; give another name, or delete that one")
        if not self.pieces_between(recording.start, recording.first, recording.last):
            raise ValueError("nothing was recorded then; name a time of the last 100 minutes")
        with self._connection:
            self._connection.execute(
                "INSERT INTO kept VALUES (?, ?, ?, ?)",
                (recording.name.strip(), recording.start, recording.first, recording.last),
            )

    def delete(self, name: str) -> None:
        """Keeps a recording no longer; it goes when the ring has no place for it. ValueError where there is none.

        name: of the recording.
        """
        with self._connection:
            if self._connection.execute("DELETE FROM kept WHERE name = ?", (name,)).rowcount == 0:
                raise ValueError(f"there is no recording {name!r}; there are {self._names()}")

    def forget(self, keys: Iterable[str]) -> float:
        """Removes contents of own faces, and clips and sounds, for good, with all that was recorded while the cast had
        them, or they were needed; returns the seconds of that. keys: of the contents."""
        forgotten = set(keys)
        casts = forgotten | {digest for digest, cast in self.casts().items() if forgotten.intersection(cast.contents)}
        rows = self._connection.execute("SELECT id, last - first, casts FROM piece").fetchall()
        gone = [(number, seconds) for number, seconds, played in rows if casts.intersection(played.split())]
        self._connection.execute("PRAGMA secure_delete = ON").fetchone()
        with self._connection:
            self._connection.executemany("DELETE FROM piece WHERE id = ?", [(number,) for number, _ in gone])
            self._forget_unplayed()
        for each in self.kept():
            if not self.pieces_between(each.start, each.first, each.last):
                self.delete(each.name)
        self._connection.execute("VACUUM")
        self._connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()
        return float(sum(seconds for _, seconds in gone))

    def kept(self) -> list[KeptRecording]:
        """The recordings that are kept, by name."""
        rows = self._connection.execute("SELECT name, start, first, last FROM kept ORDER BY name")
        return [KeptRecording(*row) for row in rows]

    def kept_named(self, name: str) -> KeptRecording:
        """The recording of a name; ValueError, with the names that there are, where there is none."""
        found = next((each for each in self.kept() if each.name == name), None)
        if found is None:
            raise ValueError(f"there is no recording {name!r}; there are {self._names()}")
        return found

    def pieces(self) -> list[Piece]:
        """All pieces, the oldest first."""
        rows = self._connection.execute(
            "SELECT piece.id, start, first, last, ticks, start.written + first - start.clock, program FROM piece "
            "JOIN start ON start.id = start ORDER BY piece.id"
        )
        return [Piece(*row) for row in rows]

    def pieces_between(self, start: int, first: float, last: float) -> list[Piece]:
        """The pieces of a start of the show that have something of a time. first, last: seconds, monotonic."""
        return [
            piece for piece in self.pieces() if piece.start == start and piece.first <= last and first <= piece.last
        ]

    def markers(self) -> list[Marker]:
        """All markers, the oldest first."""
        rows = self._connection.execute(
            "SELECT start, at, name, who FROM marker JOIN piece ON piece.id = piece ORDER BY marker.id"
        )
        return [Marker(*row) for row in rows]

    def read(self, piece: int) -> bytes | list[bytes]:
        """What happened in a piece: as it was packed, or a second at a time where it is not packed yet; KeyError where
        it is not there any more. piece: its id."""
        row = self._connection.execute("SELECT packed FROM piece WHERE id = ?", (piece,)).fetchone()
        if row is None:
            raise KeyError(piece)
        if row[0] is not None:
            return bytes(row[0])
        rows = self._connection.execute("SELECT data FROM second WHERE piece = ? ORDER BY id", (piece,))
        return [bytes(row[0]) for row in rows]

    def casts(self) -> dict[str, StoredCast]:
        """The casts that were played, by digest."""
        rows = self._connection.execute('SELECT digest, base, own, contents FROM "cast"')
        return {row[0]: StoredCast(row[0], row[1], row[2], tuple(row[3].split())) for row in rows}

    def contents(self, keys: Sequence[str]) -> dict[str, bytes]:
        """Contents of own items, by key; those that are not there are left out."""
        found: dict[str, bytes] = {}
        for key in keys:
            row = self._connection.execute("SELECT data FROM content WHERE key = ?", (key,)).fetchone()
            found |= {} if row is None else {key: row[0]}
        return found

    def copy_into(self, path: Path) -> None:
        """Copies the recording as it is now into a new file; others may write meanwhile."""
        make_private(path)
        copy = sqlite3.connect(path)
        try:
            self._connection.backup(copy)
            copy.execute("PRAGMA journal_mode = DELETE").fetchone()
        finally:
            copy.close()

    def close(self) -> None:
        """Closes the file."""
        self._connection.close()

    def _names(self) -> str:
        return ", ".join(each.name for each in self.kept()) or "none"


def open_recording(path: Path, *, new: bool = False) -> RecordingFile:
    """Opens a recording.

    Parameters
    ----------
    path : Path
        Of the recording (`recording_path`).
    new : bool
        Whether one is made where there is none.

    Returns
    -------
    RecordingFile
        To be closed.

    Raises
    ------
    ShowFileError
        Where there is none, where it cannot be used, or another version wrote it.
    """
    if not new and not path.exists():
        raise ShowFileError(f"there is no recording {path}: a show makes one while it plays.")
    try:
        make_private(path)
        connection = sqlite3.connect(path, timeout=BUSY_SECONDS, check_same_thread=False)
        try:
            _prepare(connection, path)
        except BaseException:
            connection.close()
            raise
    except (OSError, sqlite3.Error) as error:
        raise ShowFileError(
            f"{path} cannot be used ({explain_database_error(error)}): mend that, or move it away."
        ) from error
    return RecordingFile(connection, path)


def _prepare(connection: sqlite3.Connection, path: Path) -> None:
    connection.execute("PRAGMA journal_mode = WAL").fetchone()
    connection.execute("PRAGMA foreign_keys = ON")
    connection.execute("PRAGMA synchronous = NORMAL")
    (application,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_schema").fetchone()
    if (application, tables) == (0, 0):
        connection.executescript(
            f"BEGIN; PRAGMA application_id = {APPLICATION_ID}; PRAGMA user_version = {VERSION}; {_SCHEMA} COMMIT;"
        )
    elif (application, version) != (APPLICATION_ID, VERSION):
        what = f"of version {version}" if application == APPLICATION_ID else "no recording of a show"
        raise ShowFileError(f"{path} is {what}; this Omote reads version {VERSION}. Move it away to begin a new one.")
