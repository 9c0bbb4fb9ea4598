"""Draws the stimuli of a table into a folder, and writes a table of what was drawn."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec

from omote import __version__
from omote.interchange.formats.atomic_file import write_whole
from omote.server.headless.clip_pictures import (
    SIDECAR,
    ClipPictures,
    film_pictures,
    find_ffmpeg,
    find_film_sound,
    write_sidecar,
)
from omote.server.headless.picture_run import PictureFile, PictureProgress, PictureRun, PictureStudio, draw_runs
from omote.show.objects.clips import StoredClip
from omote.showfile.inspection import inspect_show
from omote.stage_data.picture_setting import Setting
from omote.stage_data.picture_sidecar import hash_picture, read_sidecar, sidecar_path
from omote.stage_data.stimulus_table import Stimulus, read_stimuli

DRAWN = "drawn.csv"
"""The table of what was drawn, in the folder of the pictures."""


@dataclass(frozen=True, eq=False)
class StimulusRun:
    """What a table wants drawn: its rows, headings that say nothing here, and a run for each setting of pictures."""

    stimuli: Sequence[Stimulus]
    own: Sequence[str]
    folder: Path
    runs: Sequence[PictureRun]

    @property
    def count(self) -> int:
        """How many pictures there are."""
        return sum(len(run.pictures) for run in self.runs)

    @property
    def waiting(self) -> int:
        """How many of them are not there yet."""
        return sum(len(run.waiting) for run in self.runs)

    def refuse_foreign(self) -> None:
        """Rejects, by FileExistsError, to overwrite what Omote did not draw, or what was changed since."""
        for run in self.runs:
            run.refuse_foreign()
        for stimulus in self.stimuli:
            film = self.folder / stimulus.film
            if film.is_file() and not is_film_of(film, read_clip_sidecar(self.folder, stimulus)):
                raise FileExistsError(
                    f"{film} is there already and is not as Omote made it; it stays as it is: --force replaces it, or "
                    "give its row another name"
                )


def refuse_own_table(table: Path, folder: Path, /) -> None:
    """Raises ValueError where the table of what is drawn would take the place of the design.

    table: the file; folder: that gets the pictures.
    """
    if table.resolve() == (folder / DRAWN).resolve():
        raise ValueError(f"{table} is where the table of what was drawn goes; give the design another name")


def plan_stimuli(
    studio: PictureStudio, data: bytes, folder: Path, /, *, show: str = "", fresh: bool = False
) -> StimulusRun:  # fmt: skip
    """Everything that a table wants drawn; TableError (a ValueError) with all that is wrong in it.

    studio: the cast and the pages; data: the table, CSV; folder: that gets the pictures; show: the show file of the
    cast, "" for none; fresh: draws again what is there.
    """
    stimuli, own = read_stimuli(data, studio.cast, show=show, clips=studio.clips)
    if any(stimulus.film for stimulus in stimuli):
        find_ffmpeg()
    files: dict[Setting, list[PictureFile]] = {}
    for stimulus in stimuli:
        for name, request in zip(stimulus.files, stimulus.frames, strict=True):
            files.setdefault(request.setting, []).append(studio.file_of(request, folder / name))
    return StimulusRun(
        stimuli, own, folder, [PictureRun(chosen, those, fresh=fresh) for chosen, those in files.items()]
    )


Lost = dict[int, str]
"""Why rows could not be drawn, in sentences by their numbers."""


def draw_planned(
    studio: PictureStudio, planned: StimulusRun, report: Callable[[PictureProgress], None], /, *, jobs: int = 1
) -> Lost:
    """Draws what waits; returns the rows that could not be drawn, each of which costs itself. Errors as `draw_runs`.

    studio: the cast and the pages; planned: of `plan_stimuli`; report: told of each picture; jobs: browsers at once.
    """
    lost: Lost = {}
    rows = {planned.folder / name: stimulus for stimulus in planned.stimuli for name in stimulus.files}

    def lose(file: PictureFile, error: Exception) -> set[Path]:
        stimulus = rows[file.path]
        lost[stimulus.row] = f"row {stimulus.row}, {stimulus.name}: {error}"
        return {planned.folder / name for name in stimulus.files}

    for stimulus in planned.stimuli:
        (planned.folder / stimulus.files[0]).parent.mkdir(parents=True, exist_ok=True)
    if waiting := [run for run in planned.runs if run.waiting]:
        there = planned.count - sum(len(run.pictures) for run in waiting)

        def tell(made: PictureProgress) -> None:
            report(PictureProgress(made.path, made.seconds, there + made.number, planned.count))

        draw_runs(studio, waiting, tell, jobs=jobs, lose=lose)
    return lost


def finish_stimuli(studio: PictureStudio, planned: StimulusRun, lost: Lost, tell: Callable[[str], None], /) -> Lost:
    """Writes what lies beside the pictures of each clip, makes its film, and writes the table of all; returns the rows
    that are lost then, each of which costs itself.

    studio: with the show file; planned: whose pictures are drawn; lost: those that are not; tell: is told of each film,
    in a sentence.
    """
    lost = dict(lost)
    drawn = [stimulus for stimulus in planned.stimuli if stimulus.row not in lost]
    films = sum(bool(stimulus.film) for stimulus in drawn)
    made = 0
    for stimulus in drawn:
        made += bool(stimulus.film)
        try:
            if stimulus.fps and _finish_clip(studio, planned.folder, stimulus, tell) and stimulus.film:
                tell(f"{stimulus.film}, film {made} of {films}.")
        except RuntimeError as error:
            lost[stimulus.row] = f"row {stimulus.row}, {stimulus.name}: {error}"
    write_whole(
        planned.folder / DRAWN, _list_drawn(planned, [each for each in planned.stimuli if each.row not in lost])
    )
    return lost


def _finish_clip(studio: PictureStudio, folder: Path, stimulus: Stimulus, tell: Callable[[str], None]) -> bool:
    """Writes what lies beside the pictures of a clip, and makes its film; returns whether anything was to be done."""
    wanted = _describe_clip(studio, folder, stimulus)
    there = read_clip_sidecar(folder, stimulus)
    film = folder / stimulus.film
    same = there is not None and msgspec.structs.replace(there, film="") == wanted
    if same and (not stimulus.film or is_film_of(film, there)):
        return False
    if stimulus.film:
        sound = None
        if stimulus.clip is not None and studio.show is not None:
            sound = find_film_sound(studio.show, stimulus.clip, lambda why: tell(f"row {stimulus.row}: {why}"))
        pictures = folder / stimulus.name / "%04d.png"
        made = film_pictures(film, pictures, stimulus.fps, len(stimulus.frames), sound)
        wanted = msgspec.structs.replace(wanted, film=made)
    write_sidecar(folder / stimulus.name / SIDECAR, wanted)
    return True


def _describe_clip(studio: PictureStudio, folder: Path, stimulus: Stimulus) -> ClipPictures:
    """What lies beside the pictures of a clip, which are drawn, without its film."""
    request = stimulus.frames[0]
    motion = ""
    if request.clip and studio.show is not None:
        motion = hash_picture(studio.show.stored.documents[StoredClip.kind][request.clip])
    names = [Path(name).name for name in stimulus.files]
    return ClipPictures(
        omote=__version__,
        clip=request.clip,
        motion=motion,
        face=request.face[0],
        cast=studio.cast.digest,
        rate=stimulus.fps,
        seconds=len(stimulus.frames) / stimulus.fps,
        size=(request.setting.width, request.setting.height),
        quality=request.quality,
        frames={name: number / stimulus.fps for number, name in enumerate(names)},
        pictures={
            name: read_sidecar(sidecar_path(folder / file)).picture
            for name, file in zip(names, stimulus.files, strict=True)
        },
        row={heading: cell for heading, cell in stimulus.cells.items() if cell},
    )


def read_clip_sidecar(folder: Path, stimulus: Stimulus) -> ClipPictures | None:
    """What lies beside the pictures of a clip, None for nothing, or for what is none.

    folder: of all stimuli; stimulus: the clip.
    """
    try:
        return msgspec.json.decode((folder / stimulus.name / SIDECAR).read_bytes(), type=ClipPictures)
    except (OSError, msgspec.DecodeError, UnicodeDecodeError):
        return None


def is_film_of(film: Path, sidecar: ClipPictures | None) -> bool:
    """Whether a film is there as its sidecar says. sidecar: None for none."""
    return sidecar is not None and film.is_file() and hash_picture(film.read_bytes()) == sidecar.film


def draw_stimuli(
    table: str | Path, folder: str | Path, *, show: str | Path | None = None, jobs: int = 1, fresh: bool = False
) -> list[Path]:  # fmt: skip
    """Draws the pictures and clips of a table, a row each, with a sidecar beside each picture.

    What is there already and is the same is not drawn again. Beside the pictures lies `drawn.csv`: each picture with
    its row, its SHA-256, and which share of it was cut off to match its luminance, as black and as white.

    Parameters
    ----------
    table : str or Path
        A CSV with a line of headings; docs/howto/stimuli.md says which there are.
    folder : str or Path
        That gets the pictures.
    show : str or Path, optional
        A show file whose own faces, expressions and motion clips may be named too.
    jobs : int
        Browsers that draw at once.
    fresh : bool
        Draws again what is there.

    Returns
    -------
    list of Path
        The pictures, in the order of the table; those of a clip in a folder of their own.

    Raises
    ------
    ValueError
        With everything that is wrong in the table, by row and column, before anything is drawn.
    OSError
        Where the table cannot be read, a picture there is not Omote's, or a file cannot be written.

    Notes
    -----
    FileNotFoundError where there is no Chromium, or no ffmpeg for a film; BrowserError (a RuntimeError) where it does
    not draw at all. A row that cannot be drawn costs itself: RuntimeError with those at the end.

    Examples
    --------
    >>> pictures = omote.draw_stimuli("design.csv", "out")  # doctest: +SKIP

    References
    ----------
    docs/conventions.md
    """
    refuse_own_table(Path(table), Path(folder))
    if not Path(table).exists():
        raise FileNotFoundError(f"there is no table {table}; name one that is there")
    data = Path(table).read_bytes()
    studio = PictureStudio(None if show is None else inspect_show(Path(show)))
    planned = plan_stimuli(studio, data, Path(folder), show="" if show is None else str(show), fresh=fresh)
    planned.refuse_foreign()
    lost = draw_planned(studio, planned, lambda _: None, jobs=jobs)
    if lost := finish_stimuli(studio, planned, lost, lambda _: None):
        raise RuntimeError(f"{'; '.join(lost.values())}; all other rows are drawn")
    return [planned.folder / name for stimulus in planned.stimuli for name in stimulus.files]


def _list_drawn(planned: StimulusRun, drawn: Sequence[Stimulus]) -> bytes:
    """The table of what was drawn: a row for each picture, with the cells of its row."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    headings = [heading for heading in planned.stimuli[0].cells if heading and heading != "name"]
    writer.writerow(["name", "file", "second", "sha256", "cut_black", "cut_white", *headings])
    for stimulus in drawn:
        for name, second in _frames_of(stimulus):
            sidecar = read_sidecar(sidecar_path(planned.folder / name))
            cut = sidecar.clipped
            shares = ("", "") if cut is None else (f"{cut.black:.4f}", f"{cut.white:.4f}")
            cells = [stimulus.cells[heading] for heading in headings]
            writer.writerow([stimulus.name, name, second, sidecar.picture, *shares, *cells])
    return text.getvalue().encode()


def _frames_of(stimulus: Stimulus) -> Iterator[tuple[str, str]]:
    """The file of each picture of a stimulus, and its second in the clip, "" of a picture alone."""
    for number, name in enumerate(stimulus.files):
        yield name, f"{number / stimulus.fps:.6g}" if stimulus.fps else ""
