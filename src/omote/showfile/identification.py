"""Tells from a file's own bytes whether it is a show file, was one, or is somebody else's; only reads.

What is somebody else's is never opened by SQLite, locked, renamed or written, whatever its name. The bytes are those of
https://sqlite.org/fileformat.html: application id at 68, b-tree pages, and in a log the frames of page 1.
"""

from __future__ import annotations

import codecs
import stat
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Literal

from omote.interchange.formats.error_reasons import explain_error
from omote.showfile.schema import APPLICATION_ID, ShowFileError

SUFFIX = ".omote"
MAGIC = b"SQLite format 3\0"
LOG_MAGICS = (b"\x37\x7f\x06\x82", b"\x37\x7f\x06\x83")
OURS = struct.pack(">I", APPLICATION_ID)
ID_PLACE = 68
CELLS_PLACE = 103
HEADER = 100
LOG_HEADER = 32
FRAME_HEADER = 24
MOST_READ = 4 * 2**20
"""Bytes in which pages of a database are looked for: a show file has some in each of its first few."""
PAGE_SIZES = (4096, 512, 1024, 2048)
LEAVES = (10, 13)
BRANCHES = (2, 5)

FileKind = Literal["missing", "empty", "show", "remains", "foreign"]


class ForeignFileError(ShowFileError):
    """The file was never a show; it is untouched."""


@dataclass(frozen=True)
class Identity:
    """What a file is.

    "empty": nothing is in it yet: no byte, or a database that a start was about to fill. "show": its header, or its
    log's, has Omote's id, whatever became of the rest. "remains": it may be what is left of one: nothing but its whole
    backup can tell. "foreign": anything else; noun: what, for people.
    """

    kind: FileKind
    noun: str = ""


def identify(path: Path, /) -> Identity:
    """What the file at a path is; ShowFileError where it cannot be read."""
    try:
        if not path.exists():
            return Identity("missing")
        if not path.is_file():
            return Identity("foreign", _special_noun(path.stat().st_mode))
        with path.open("rb") as file:
            return _identify_bytes(file, path)
    except (OSError, ValueError) as error:
        raise ShowFileError(
            f"{path} cannot be read ({explain_error(error)}): name another file, or make it readable."
        ) from error


def reject_foreign(path: Path, /) -> Identity:
    """What the file at a path is; ForeignFileError, with what it is instead, where it was never a show."""
    identity = identify(path)
    if identity.kind == "foreign":
        example = path / "show.omote" if path.is_dir() else "show.omote"
        raise ForeignFileError(
            f"{path} is {identity.noun}, not a show; it stays as it is. Name a show file, such as {example}."
        )
    return identity


def require_show(path: Path, /) -> None:
    """Rejects, by ForeignFileError, where no show can be: an empty file becomes one only where its name says so."""
    if reject_foreign(path).kind == "empty" and path.suffix.lower() != SUFFIX:
        raise ForeignFileError(
            f"{path} is an empty file whose name does not end in {SUFFIX}; it stays as it is. Delete it if it is to "
            "become a show, or name another file."
        )


def is_own_log(path: Path, /) -> bool:
    """Whether the log beside a show file that is not there was written by Omote, as far as can be told."""
    log = path.with_name(path.name + "-wal")
    application = _log_application(log)
    return application == OURS or (application is None and path.suffix.lower() == SUFFIX and _begins(log, LOG_MAGICS))


def locate_show(path: Path, /) -> Path:
    """Where a show file really lies: links are followed, so that each file has one lock and one set of backups."""
    try:
        return path.resolve()
    except (OSError, RuntimeError) as error:
        raise ShowFileError(f"{path} cannot be opened: its links lead in a circle; name another file.") from error


def require_folder(path: Path, /) -> None:
    """Rejects, by ShowFileError, a show file whose folder is not there: a mistyped path shall make none."""
    if not path.parent.is_dir():
        if path.parent.exists():
            raise ShowFileError(f"{path} cannot be made: {path.parent} is no folder; name another file.")
        raise ShowFileError(
            f"{path} cannot be made: its folder {path.parent} is not there; make it first, or name another file."
        )


def _identify_bytes(file: BinaryIO, path: Path) -> Identity:
    head = file.read(HEADER + 8)
    if not head:
        return Identity("empty")
    if head.startswith(MAGIC) and len(head) > ID_PLACE + len(OURS):
        return _identify_database(head, path)
    data = head + file.read(MOST_READ)
    if MAGIC.startswith(head[: len(MAGIC)]) or not any(head[: len(MAGIC)]) or (not _is_text(data) and _has_pages(data)):
        return Identity("show" if _log_application(path.with_name(path.name + "-wal")) == OURS else "remains")
    return Identity("foreign", "a text file" if _is_text(data) else "a file of another kind")


def _identify_database(head: bytes, path: Path) -> Identity:
    application = head[ID_PLACE : ID_PLACE + len(OURS)]
    if application == OURS:
        return Identity("show")
    log = _log_application(path.with_name(path.name + "-wal"))
    if not any(application) and log == OURS:  # its first transaction is in the log only
        return Identity("show")
    if not any(application) and not log and _is_blank(head, path.stat().st_size):
        return Identity("empty")
    return Identity("foreign", "a database of another program")


def _is_blank(head: bytes, size: int) -> bool:
    """Whether a database has one page without a table, and a log: what a start that was cut off leaves behind."""
    (page,) = struct.unpack_from(">H", head, len(MAGIC))
    (tables,) = struct.unpack_from(">H", head, CELLS_PLACE)
    return size == page and tables == 0 and head[18:20] == b"\x02\x02"


def _log_application(log: Path) -> bytes | None:
    """The application id in a write-ahead log's last copy of page 1; None where it has none, b"" for no log."""
    if not log.is_file():
        return None
    if not _begins(log, LOG_MAGICS):
        return b"" if log.stat().st_size else None
    with log.open("rb") as file:
        data = file.read(16 * MOST_READ)
        application = None
    (page,) = struct.unpack_from(">I", data.ljust(LOG_HEADER, b"\0"), 8)
    for at in range(LOG_HEADER, len(data) - FRAME_HEADER - HEADER, FRAME_HEADER + max(page, 512)):
        start = at + FRAME_HEADER
        # A loss of power may leave a frame's head without its page.
        if struct.unpack_from(">I", data, at)[0] == 1 and data.startswith(MAGIC, start):
            application = data[start + ID_PLACE : start + ID_PLACE + len(OURS)]
    return application


def _begins(path: Path, magics: tuple[bytes, ...]) -> bool:
    with path.open("rb") as file:
        return file.read(4).startswith(magics)


def _has_pages(data: bytes) -> bool:
    """Whether a page of a b-tree with something in it stands where one would, were this a database."""
    return any(_is_page(data[at : at + size]) for size in PAGE_SIZES for at in range(size, len(data) - size + 1, size))


def _is_page(page: bytes) -> bool:
    """Whether a page is one of a b-tree: a known kind, and cells that lie where its header says (section 1.6)."""
    if page[0] not in LEAVES + BRANCHES:
        return False
    free, cells, start = struct.unpack_from(">HHH", page, 1)
    begin = 8 if page[0] in LEAVES else 12
    if not 0 < cells <= (len(page) - begin) // 2 or free >= len(page) or not begin + 2 * cells <= start < len(page):
        return False
    return all(start <= place < len(page) for place in struct.unpack_from(f">{cells}H", page, begin))


def _is_text(data: bytes) -> bool:
    try:
        text = codecs.getincrementaldecoder("utf-8")().decode(data)  # what was read may end inside a character
    except UnicodeDecodeError:
        return False
    return not any(letter < " " and letter not in "\t\n\r\f" for letter in text)


def _special_noun(mode: int) -> str:
    if stat.S_ISDIR(mode):
        return "a folder"
    return "a pipe" if stat.S_ISFIFO(mode) else "a socket" if stat.S_ISSOCK(mode) else "a device"
