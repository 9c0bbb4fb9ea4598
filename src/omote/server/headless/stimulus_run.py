"""Draws the stimuli of a table into a folder, and writes a table of what was drawn."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from omote.interchange.formats.atomic_file import write_whole
from omote.server.headless.picture_run import PictureFile, PictureProgress, PictureRun, PictureStudio, draw_runs
from omote.showfile.inspection import inspect_show
from omote.stage_data.picture_setting import Setting
from omote.stage_data.picture_sidecar import read_sidecar, sidecar_path
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
    stimuli, own = read_stimuli(data, studio.cast, show=show)
    files: dict[Setting, list[PictureFile]] = {}
    for stimulus in stimuli:
        for name, request in zip(stimulus.files, stimulus.frames, strict=True):
            files.setdefault(request.setting, []).append(studio.file_of(request, folder / name))
    return StimulusRun(
        stimuli, own, folder, [PictureRun(chosen, those, fresh=fresh) for chosen, those in files.items()]
    )


def draw_planned(
    studio: PictureStudio, planned: StimulusRun, report: Callable[[PictureProgress], None], /, *, jobs: int = 1
) -> None:
    """Draws what waits, and writes the table of all; errors as `draw_runs`.

    studio: the cast and the pages; planned: of `plan_stimuli`; report: told of each picture; jobs: browsers at once.
    """
    for stimulus in planned.stimuli:
        (planned.folder / stimulus.files[0]).parent.mkdir(parents=True, exist_ok=True)
    if waiting := [run for run in planned.runs if run.waiting]:
        there = planned.count - sum(len(run.pictures) for run in waiting)

        def tell(made: PictureProgress) -> None:
            report(PictureProgress(made.path, made.seconds, there + made.number, planned.count))

        draw_runs(studio, waiting, tell, jobs=jobs)
    write_whole(planned.folder / DRAWN, _list_drawn(planned))


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
        A show file whose own faces and expressions may be named too.
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
    FileNotFoundError where there is no Chromium, BrowserError (a RuntimeError) where it does not draw.

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
    for run in planned.runs:
        run.refuse_foreign()
    draw_planned(studio, planned, lambda _: None, jobs=jobs)
    return [planned.folder / name for stimulus in planned.stimuli for name in stimulus.files]


def _list_drawn(planned: StimulusRun) -> bytes:
    """The table of what was drawn: a row for each picture, with the cells of its row."""
    text = io.StringIO(newline="")
    writer = csv.writer(text)
    headings = [heading for heading in planned.stimuli[0].cells if heading and heading != "name"]
    writer.writerow(["name", "file", "second", "sha256", "cut_black", "cut_white", *headings])
    for stimulus in planned.stimuli:
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
