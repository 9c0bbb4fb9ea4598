"""The commands `omote render`, `grid` and `redraw`: pictures into files, with progress, and a sidecar beside each."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.terminal import exit_on_refusal, say

if TYPE_CHECKING:
    from omote.server.headless.picture_run import PictureRun, Progress
    from omote.stage_data.picture_request import Request

Output = Annotated[Path, typer.Option("--output", "-o", help="The picture to write: .png, .jpg.")]
FacesOption = Annotated[list[str] | None, typer.Option("--face", help="A face; several mix: kaori=0.5, dog=0.5.")]
ExpressionsOption = Annotated[list[str] | None, typer.Option("--expression", help="An expression: smile, smile=0.7.")]
ChannelsOption = Annotated[list[str] | None, typer.Option("--channel", help="A channel over it: jawOpen=0.5.")]
LightOption = Annotated[str, typer.Option(help="theatre, portrait, flat or a mix: theatre=0.5+flat.")]
BackgroundOption = Annotated[str | None, typer.Option(help="A colour behind the head: #00b140.")]
TransparentOption = Annotated[bool, typer.Option("--transparent", help="Nothing behind the head.")]
QualityOption = Annotated[str, typer.Option(help="lowest, low, medium or high.")]
ShowOption = Annotated[Path | None, typer.Option(help="A show file (.omote) whose own work can be named too.")]
JobsOption = Annotated[int, typer.Option("--jobs", "-j", min=1, max=64, help="Browsers that draw at once.")]
FreshOption = Annotated[bool, typer.Option("--fresh", help="Draw again what is there already.")]


def render(
    output: Output,
    face: FacesOption = None,
    expression: ExpressionsOption = None,
    channel: ChannelsOption = None,
    turn: Annotated[str, typer.Option(help="The head's yaw, pitch and roll, degrees: 30,0,-5.")] = "",
    gaze: Annotated[str, typer.Option(help="The eyes' yaw and pitch, degrees.")] = "",
    size: Annotated[str, typer.Option(help="Width x height, pixels.")] = "640x720",
    light: LightOption = "theatre",
    background: BackgroundOption = None,
    transparent: TransparentOption = False,
    quality: QualityOption = "high",
    show: ShowOption = None,
    fresh: FreshOption = False,
) -> None:
    """Draws one picture of a face, without a window, as the stage draws it."""
    from omote.stage_data.picture_request import RenderRequest

    request = RenderRequest(
        face=tuple(face or ["generic"]), expression=tuple(expression or []), channel=tuple(channel or []), turn=turn,
        gaze=gaze, size=size, light=light, background=background, transparent=transparent, quality=quality,
        show="" if show is None else str(show),
    )  # fmt: skip
    draw(output, request, fresh=fresh)


def grid(
    output: Output,
    faces: Annotated[str, typer.Option(help="The rows: faces, or mixes (kaori=0.5+dog=0.5), by commas.")] = "",
    morph: Annotated[str, typer.Option(help="The columns instead: steps from face to face, kaori:old:11.")] = "",
    expressions: Annotated[str, typer.Option(help="Expressions, or mixes of them, by commas.")] = "neutral",
    turns: Annotated[str, typer.Option(help="Each expression at these yaws, degrees, by commas.")] = "0",
    labels: Annotated[bool, typer.Option("--labels/--no-labels", help="Write the names beside the pictures.")] = True,
    size: Annotated[str, typer.Option(help="Width x height of one picture, pixels.")] = "240x270",
    light: LightOption = "theatre",
    background: BackgroundOption = None,
    transparent: TransparentOption = False,
    quality: QualityOption = "high",
    show: ShowOption = None,
    jobs: JobsOption = 1,
    fresh: FreshOption = False,
) -> None:
    """Draws pictures in rows and columns: faces by expressions, by turns, or the steps of a morph."""
    from omote.stage_data.picture_request import GridRequest

    request = GridRequest(
        faces=faces, morph=morph, expressions=expressions, turns=turns, labels=labels, size=size, light=light,
        background=background, transparent=transparent, quality=quality, show="" if show is None else str(show),
    )  # fmt: skip
    draw(output, request, fresh=fresh, jobs=jobs)


def redraw(
    sidecar: Annotated[Path, typer.Argument(help="What lies beside a picture: smile.png.json.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The picture to write; else the one beside it.")
    ] = None,
    jobs: JobsOption = 1,
) -> None:
    """Draws a picture or a grid again from its sidecar, with every parameter as it was."""
    from omote.stage_data.picture_sidecar import read_sidecar

    with exit_on_refusal():
        written = read_sidecar(sidecar)
        draw(output or sidecar.with_suffix(""), written.request, fresh=True, jobs=jobs, before=written.cast)


def draw(path: Path, request: Request, *, fresh: bool = False, jobs: int = 1, before: str | None = None) -> None:
    """Draws what a request wants, or ends the command with an error message.

    before: the digest of the cast that it was drawn with once; another cast is told of.
    """
    with exit_on_refusal():
        from omote.interchange.formats.atomic_file import check_writable
        from omote.interchange.formats.picture_names import picture_kind
        from omote.server.headless.picture_run import PictureStudio, draw_run

        picture_kind(path)
        check_writable(path)
        _ = request.setting
        studio = PictureStudio(Path(request.show) if request.show else None)
        if before not in (None, studio.cast.digest):
            say("it was drawn with another cast than this one; the faces may differ.")
        run = studio.plan(request, path, fresh=fresh)
        if run.complete:
            say(f"{path} is there already, drawn from the same parameters; --fresh draws it again.")
            return
        with shown_progress(run, path) as report:
            draw_run(studio, run, report, jobs=jobs)
    say(f"{path}: {len(run.pictures)} {'picture' if len(run.pictures) == 1 else 'pictures'}.")


@contextmanager
def shown_progress(run: PictureRun, path: Path) -> Iterator[Callable[[Progress], None]]:
    """Shows how far a run is: a bar with the time that is left on a terminal, else a line for each picture."""
    there = len(run.pictures) - len(run.waiting)
    if there and run.waiting:
        say(f"{there} of {len(run.pictures)} pictures are there already; going on.")
    try:
        if sys.stderr.isatty():
            yield from _bar(run, path, there)
        else:
            yield _lines(run)
    except KeyboardInterrupt:
        say("stopped; what is drawn stays, and the same command goes on from there.")
        raise typer.Exit(130) from None


def _bar(run: PictureRun, path: Path, there: int) -> Iterator[Callable[[Progress], None]]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(compact=True))
    with Bar(*columns, TextColumn("left"), console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(path.name, total=len(run.pictures), completed=there)
        yield lambda progress: bar.update(task, completed=progress.number, description=progress.path.name)


def _lines(run: PictureRun) -> Callable[[Progress], None]:
    began, first = time.monotonic(), len(run.pictures) - len(run.waiting)

    def report(progress: Progress) -> None:
        left = progress.total - progress.number
        share = (time.monotonic() - began) / (progress.number - first)
        rest = f"; about {left * share:.0f} s left" if left else ""
        say(f"{progress.number} of {progress.total}: {progress.path.name}, {progress.seconds:.1f} s{rest}")

    return report
