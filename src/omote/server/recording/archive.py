"""A day of a show as one archive: the show file, its recording, its cues as text, and who did what."""

from __future__ import annotations

import csv
import io
import signal
import sqlite3
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import NoReturn

from omote.interchange.formats.cue_toml import format_cues
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.show.cues.cue_book import read_book
from omote.showfile.inspection import inspect_show
from omote.showfile.integrity import open_read_only
from omote.showfile.recording_file import SUFFIX, RecordingFile


def write_archive(
    show: Path,
    recorded: RecordingFile,
    recording: RecordedShow,
    archive: Path,
    tell: Callable[[str], object] = lambda _: None,
) -> list[str]:
    """Writes the archive, whole or not at all, and returns the names of the files in it.

    Parameters
    ----------
    show : Path
        The show file; a show may play it.
    recorded, recording : RecordingFile, RecordedShow
        Its recording, opened.
    archive : Path
        Where nothing lies yet.
    tell : callable
        Told what is done next, in a few words: a day may take minutes.

    Raises
    ------
    FileExistsError
        Where something lies there.
    OSError, sqlite3.Error, ShowFileError
        Where the disk fails.
    """
    if archive.exists():
        raise FileExistsError(f"{archive} is there already; name another file")
    book, _ = read_book(lambda kind: inspect_show(show).stored.documents.get(kind, {}))
    with _ending_orderly(), tempfile.TemporaryDirectory(dir=archive.parent) as folder:
        made = Path(folder)
        tell(f"copies {show.name}")
        with closing(open_read_only(show)) as connection, closing(sqlite3.connect(made / show.name)) as copy:
            connection.backup(copy)
        tell("copies the recording")
        recorded.copy_into(made / (show.name + SUFFIX))
        for name in book.orders:
            (made / f"{file_name(name)}.cues.toml").write_text(format_cues(book.cues_of(name)), encoding="utf-8")
        starts = sorted({piece.start for piece in recorded.pieces()})
        for place, start in enumerate(starts, 1):
            tell(f"writes who did what in start {place} of {len(starts)}")
            (made / f"log-{start}.csv").write_text(write_log(recorded, recording, start), encoding="utf-8")
        names = sorted(path.name for path in made.iterdir())
        packed = made / "archive.zip"
        with zipfile.ZipFile(packed, "x", zipfile.ZIP_DEFLATED) as writer:
            for name in names:
                tell(f"packs {name}, {(made / name).stat().st_size / 1e6:.1f} MB")
                writer.write(made / name, name)
        packed.rename(archive)
    return names


@contextmanager
def _ending_orderly() -> Iterator[None]:
    """Where SIGTERM ends the work as Ctrl-C does: what is half done is deleted."""

    def end(number: int, _: object) -> NoReturn:
        raise SystemExit(128 + number)

    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def write_log(recorded: RecordingFile, recording: RecordedShow, start: int) -> str:
    """Who did what in a start of the show, as CSV: seconds from its beginning, who, what, of whom, how often. recorded,
    recording: as of `write_archive`."""
    pieces = [piece for piece in recorded.pieces() if piece.start == start]
    first = pieces[0].first
    written = io.StringIO()
    rows = csv.writer(written)
    rows.writerow(["seconds", "who", "what", "of", "times"])
    for line in recording.log(Span(start, first, pieces[-1].last)):
        rows.writerow([f"{line.at - first:.3f}", line.who, line.what, line.of, line.times])
    return written.getvalue()


def file_name(name: str) -> str:
    """A name without what no file may be called."""
    return "".join(letter if letter.isalnum() or letter in " -_" else "_" for letter in name)
