"""The commands `omote render`, `grid` and `redraw`: pictures into files, with progress, and a sidecar beside each."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated

import typer

from omote.perform.lights import LIGHTS
from omote.terminal import INTERRUPTED, complete_name, complete_show, exit_on_refusal, fail, read_count, say

if TYPE_CHECKING:
    from omote.server.headless.picture_run import PictureProgress, PictureRun, PictureStudio
    from omote.stage_data.picture_request import Request
    from omote.stage_data.picture_sidecar import Sidecar

OutputOption = Annotated[Path, typer.Option("--output", "-o", help="The picture to write: .png, .jpg.")]
FacesOption = Annotated[
    list[str] | None, typer.Option("--face", help="A face, or a mix: kaori=0.5+dog=0.5; may be given again.")
]
ExpressionsOption = Annotated[list[str] | None, typer.Option("--expression", help="An expression: smile, smile=0.7.")]
ChannelsOption = Annotated[list[str] | None, typer.Option("--channel", help="A channel over it: jawOpen=0.5.")]
LightOption = Annotated[str, typer.Option(help=f"{', '.join(LIGHTS)} or a mix: theatre=0.5+flat.")]
BackgroundOption = Annotated[str | None, typer.Option(help="Behind the head: green, grey, or #rrggbb.")]
TransparentOption = Annotated[bool, typer.Option("--transparent", help="Nothing behind the head.")]
QualityOption = Annotated[str, typer.Option(help="lowest, low, medium, good or high.")]
HairOption = Annotated[bool, typer.Option("--hair/--no-hair", help="Whether heads wear their hair.")]
FramingOption = Annotated[
    str, typer.Option(help="A figure, and how much of it is seen: head, bust, half or full; else a head alone.")
]
MaskOption = Annotated[str, typer.Option(help="Leave the face alone: oval, or face (chin to hairline).")]
LuminanceOption = Annotated[
    float | None, typer.Option(help="The mean of relative luminance, linear light, that each picture gets: 0.2.")
]
ContrastOption = Annotated[
    float | None, typer.Option(help="The standard deviation of luminance over its mean (RMS): 0.2.")
]
ShowOption = Annotated[
    Path | None, typer.Option(callback=complete_show, help="A show file (.omote) whose own work can be named too.")
]
JobsOption = Annotated[
    int, typer.Option("--jobs", "-j", parser=read_count, metavar="COUNT", help="Browsers that draw at once.")
]
FreshOption = Annotated[bool, typer.Option("--fresh", help="Draw again what is there already.")]
ForceOption = Annotated[bool, typer.Option("--force", help="Replace a picture that Omote did not draw as it is.")]
OVERLOOKED = 0.005
"""Of what counts in a picture: so much may be cut off to match its luminance without a word."""
STOPPED = "stopped; what is drawn stays, and the same command goes on from there."
UNCHANGED = "stopped; nothing was changed."


def render(
    output: OutputOption,
    face: FacesOption = None,
    expression: ExpressionsOption = None,
    channel: ChannelsOption = None,
    turn: Annotated[str, typer.Option(help="The head's yaw, pitch and roll, degrees: 30,0,-5.")] = "",
    gaze: Annotated[str, typer.Option(help="The eyes' yaw and pitch, degrees: to 40 and 30 either way.")] = "",
    clip: Annotated[str, typer.Option(help="A motion clip of the show file, in place of all but the face.")] = "",
    at: Annotated[float, typer.Option(min=0.0, help="The second of the clip.")] = 0.0,
    framing: FramingOption = "",
    pose: Annotated[str, typer.Option(help="A pose of the figure, or a mix: bow, or bow=0.5+wave.")] = "",
    size: Annotated[str, typer.Option(help="Width x height, pixels.")] = "640x720",
    light: LightOption = "theatre",
    background: BackgroundOption = None,
    transparent: TransparentOption = False,
    quality: QualityOption = "high",
    hair: HairOption = True,
    mask: MaskOption = "",
    luminance: LuminanceOption = None,
    contrast: ContrastOption = None,
    show: ShowOption = None,
    fresh: FreshOption = False,
    force: ForceOption = False,
) -> None:
    """Draws one picture of a face, without a window, as the stage draws it."""
    from omote.stage_data.picture_request import RenderRequest

    request = RenderRequest(
        face=tuple(face or ["generic"]), expression=tuple(expression or []), channel=tuple(channel or []), turn=turn,
        gaze=gaze, clip=clip, at=at, framing=framing, pose=pose,
        size=size, light=light, background=background, transparent=transparent, quality=quality, hair=hair,
        mask=mask, luminance=luminance, contrast=contrast, show="" if show is None else str(show),
    )  # fmt: skip
    draw(output, request, fresh=fresh, force=force)


def grid(
    output: OutputOption,
    faces: Annotated[str, typer.Option(help="The rows: faces, or mixes (kaori=0.5+dog=0.5), by commas.")] = "",
    morph: Annotated[
        str, typer.Option(help="Steps from face to face as columns: kaori:old:11, 11lab, 0.5mm, 2dE or 0/30/100.")
    ] = "",
    expressions: Annotated[str, typer.Option(help="Expressions, mixes, or kinds (performed), by commas.")] = "neutral",
    turns: Annotated[str, typer.Option(help="Each expression at these yaws, degrees, by commas.")] = "0",
    labels: Annotated[bool, typer.Option("--labels/--no-labels", help="Write the names beside the pictures.")] = True,
    framing: FramingOption = "",
    size: Annotated[str, typer.Option(help="Width x height of one picture, pixels.")] = "240x270",
    light: LightOption = "theatre",
    background: BackgroundOption = None,
    transparent: TransparentOption = False,
    quality: QualityOption = "high",
    hair: HairOption = True,
    mask: MaskOption = "",
    luminance: LuminanceOption = None,
    contrast: ContrastOption = None,
    show: ShowOption = None,
    jobs: JobsOption = 1,
    fresh: FreshOption = False,
    force: ForceOption = False,
) -> None:
    """Draws pictures in rows and columns: faces by expressions, by turns, or the steps of a morph."""
    from omote.stage_data.picture_request import GridRequest

    request = GridRequest(
        faces=faces, morph=morph, expressions=expressions, turns=turns, labels=labels, framing=framing,
        size=size, light=light,
        background=background, transparent=transparent, quality=quality, hair=hair, mask=mask, luminance=luminance,
        contrast=contrast, show="" if show is None else str(show),
    )  # fmt: skip
    draw(output, request, fresh=fresh, force=force, jobs=jobs)


def redraw(
    sidecar: Annotated[Path, typer.Argument(help="The picture, or what lies beside it: smile.png.json.")],
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The picture to write; else the one beside it is proved.")
    ] = None,
    show: Annotated[
        Path | None, typer.Option(callback=complete_show, help="Where the show file lies now, if not where it was.")
    ] = None,
    jobs: JobsOption = 1,
    force: Annotated[bool, typer.Option("--force", help="Replace the picture beside it, whatever comes out.")] = False,
) -> None:
    """Draws a picture or a grid again from its sidecar; one that is there is never replaced by another unasked."""
    import msgspec

    from omote.stage_data.picture_sidecar import find_sidecar, move_request, read_record

    with exit_on_refusal():
        sidecar = find_sidecar(sidecar)
        written = read_record(sidecar)
        request = move_request(written.request, sidecar.parent, Path())
        request = request if show is None else msgspec.structs.replace(request, show=str(show))
        if request.show and not Path(request.show).exists():
            fail(f"{sidecar} was drawn from the show file {request.show}, which is not there: say where with --show.")
        if output is None and not force:
            prove(sidecar.with_suffix(""), request, written, jobs=jobs)
        else:
            draw(output or sidecar.with_suffix(""), request, fresh=True, force=force, jobs=jobs, before=written)


def draw(
    path: Path,
    request: Request,
    *,
    fresh: bool = False,
    force: bool = False,
    jobs: int = 1,
    before: Sidecar | None = None,
) -> None:
    """Draws what a request wants, or ends the command with an error message.

    before: the sidecar that the request is of; another cast or look is told of; path: of the picture; fresh: whether
    what is there is drawn again; force: whether a foreign picture is replaced; jobs: browsers at once.
    """
    path = complete_name(path, ".png")
    with exit_on_refusal():
        studio, run = plan(path, request, fresh=fresh)
        if run.complete:
            say(f"{path} is there already, drawn from the same parameters; --fresh draws it again.")
            return
        if not force:
            run.refuse_foreign()
        tell_difference(run, before)
        draw_shown(studio, run, path, jobs=jobs, stopped=STOPPED)
        clear_former(run, path)
    say(f"{path}: {len(run.pictures)} {'picture' if len(run.pictures) == 1 else 'pictures'}.")
    tell_clipped([file.path for file in run.pictures])


def tell_clipped(pictures: Sequence[Path]) -> None:
    """Says of how many pictures more was cut off to match luminance and contrast than anybody overlooks.

    pictures: those that were drawn, with their sidecars.
    """
    from omote.stage_data.picture_sidecar import read_sidecar, sidecar_path

    cut = {path: read_sidecar(sidecar_path(path)).clipped for path in pictures}
    shares = {path: (each.black, each.white) for path, each in cut.items() if each is not None}
    far = [path for path, share in shares.items() if max(share) > OVERLOOKED]
    if not far:
        return
    worst = max(far, key=lambda path: max(shares[path]))
    black, white = shares[worst]
    say(
        f"in {len(far)} of {len(pictures)} the contrast is more than the face has room for: of {worst.name} "
        f"{100.0 * black:.1f} % is cut off to black and {100.0 * white:.1f} % to white. Ask for less contrast."
    )


def prove(path: Path, request: Request, written: Sidecar, *, jobs: int) -> None:
    """Draws again what a sidecar says, elsewhere; writes it only where it is the same and no picture is there.

    path: of the picture; request: what it shows; written: what the sidecar says; jobs: browsers at once.
    """
    from omote.interchange.formats.atomic_file import write_whole
    from omote.stage_data.picture_sidecar import explain_difference, hash_picture

    there = path.exists()
    if there and hash_picture(path.read_bytes()) != written.picture:
        fail(
            f"{path} is not the picture that its sidecar is of, it was changed since; it stays as it is: -o NEW.png "
            "draws beside it, --force in its place."
        )
    with TemporaryDirectory(prefix="omote-") as folder:
        studio, run = plan(Path(folder) / path.name, request, fresh=True)
        draw_shown(studio, run, path, jobs=jobs, stopped=UNCHANGED)
        drawn = (Path(folder) / path.name).read_bytes()
    if hash_picture(drawn) != written.picture:
        why = explain_difference(written, run.whole.sidecar)
        fail(
            f"{path} comes out otherwise than its sidecar says, which was drawn {why}; nothing was changed: -o NEW.png "
            "writes it beside, --force in its place."
        )
    if not there:
        write_whole(path, drawn)
    say(f"{path}: drawn again, the same to the last byte{'' if there else '; it is there again'}.")


def plan(path: Path, request: Request, *, fresh: bool) -> tuple[PictureStudio, PictureRun]:
    """What is to be drawn and by what; ValueError, OSError where that cannot be, before anything is drawn.

    What needs no cast is checked before one is loaded: a person who mistypes an option waits for nothing.

    path: of the picture; request: what it shows; fresh: whether what is there is drawn again.
    """
    from omote.interchange.formats.atomic_file import check_writable
    from omote.interchange.formats.file_names import picture_kind
    from omote.server.headless.chromium import find_chromium
    from omote.showfile.inspection import inspect_show
    from omote.stage_data.cast_names import read_names
    from omote.stage_data.picture_request import check_names, check_request

    kind = picture_kind(path)
    request.setting.paper(kind)
    show = inspect_show(Path(request.show)) if request.show else None
    if names := read_names(None if show is None else show.stored):
        check_names(request, names)  # of a name that is mistyped and a weight beside it the name is told
    check_request(request, kind)
    check_writable(path)
    find_chromium()
    from omote.server.headless.picture_run import PictureStudio

    studio = PictureStudio(show, say)
    return studio, studio.plan(request, path, fresh=fresh)


def tell_difference(run: PictureRun, before: Sidecar | None) -> None:
    """Says where a picture is made of something else than the sidecar that it is drawn from, or than the one there,
    whose sidecar is kept.

    run: what is drawn; before: that sidecar, None for none.
    """
    from omote.stage_data.picture_sidecar import explain_difference, keep_former, read_sidecar, sidecar_path

    whole = run.whole
    if before is not None and before.record != whole.sidecar.record:
        say(f"the sidecar's picture was drawn {explain_difference(before, whole.sidecar)}.")
    elif before is None and run.states[whole.path] == "former":
        why = explain_difference(read_sidecar(sidecar_path(whole.path)), whole.sidecar)
        say(f"{whole.path} is there already, drawn {why}; it is drawn anew in its place.")
    if kept := keep_former(whole.path, whole.sidecar):
        say(f"how the one before was drawn stays in {kept}: omote redraw draws it from there.")


def clear_former(run: PictureRun, path: Path) -> None:
    """Removes the pictures of a former table of this name that this one has not; beside a single picture only says.

    run: what was drawn; path: of the picture.
    """
    from omote.server.headless.picture_run import former_pictures, pictures_folder
    from omote.stage_data.picture_sidecar import sidecar_path

    former = former_pictures(run, path)
    folder = pictures_folder(path)
    if former and run.table is None:
        say(f"{folder} still holds pictures of a former table; delete it when nothing of it is missed.")
    elif former:
        for picture in former:
            sidecar_path(picture).unlink()
            picture.unlink()
        say(f"removed from {folder} what only the table before had, pictures: {len(former)}.")


def draw_shown(studio: PictureStudio, run: PictureRun, path: Path, *, jobs: int, stopped: str) -> None:
    """Draws a run and shows how far it is.

    studio: what draws; path: of the picture; jobs: browsers at once; stopped: what is said after Ctrl-C.
    """
    from omote.server.headless.picture_run import draw_run

    with shown_progress(len(run.pictures), len(run.waiting), path, stopped) as report:
        draw_run(studio, run, report, jobs=jobs)


@contextmanager
def shown_progress(
    total: int, waiting: int, path: Path, stopped: str
) -> Iterator[Callable[[PictureProgress], None]]:  # fmt: skip
    """Shows how far a run is: a bar with the time that is left on a terminal, else a line for each picture.

    total: how many pictures there are; waiting: how many of them are not drawn yet; path: of the picture; stopped: what
    is said after Ctrl-C.
    """
    there = total - waiting
    if there and waiting:
        say(f"{there} of {total} pictures are there already; going on.")
    try:
        if sys.stderr.isatty():
            yield from _bar(total, path, there)
        else:
            yield _lines(path, there)
    except KeyboardInterrupt:
        say(stopped)
        raise typer.Exit(INTERRUPTED) from None


def _name_below(path: Path, picture: Path) -> str:
    """What a picture is called: in a folder of stimuli with that of its clip."""
    return str(picture.relative_to(path)) if picture.is_relative_to(path) else picture.name


def _bar(total: int, path: Path, there: int) -> Iterator[Callable[[PictureProgress], None]]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(compact=True))
    with Bar(*columns, TextColumn("left"), console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(path.name, total=total, completed=there)
        yield lambda progress: bar.update(task, completed=progress.number, description=_name_below(path, progress.path))


def _lines(path: Path, first: int) -> Callable[[PictureProgress], None]:
    began = time.monotonic()

    def report(progress: PictureProgress) -> None:
        left = progress.total - progress.number
        share = (time.monotonic() - began) / (progress.number - first)
        rest = f"; about {left * share:.0f} s left" if left else ""
        say(
            f"{progress.number} of {progress.total}: {_name_below(path, progress.path)}, {progress.seconds:.1f} s{rest}"
        )

    return report
