"""The command line (`omote`): each command only wires other modules, and imports heavy ones where they are used."""

from __future__ import annotations

import os
import sys
import webbrowser
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from omote.file_commands import file_app

if TYPE_CHECKING:
    from omote.model.cast import Cast
    from omote.stage_data.picture_grid import PictureGrid

Output = Annotated[Path, typer.Option("--output", "-o", help="The picture to write: .png, .jpg.")]
FacesOption = Annotated[list[str] | None, typer.Option("--face", help="A face; several mix: kaori=0.5, dog=0.5.")]
ExpressionsOption = Annotated[list[str] | None, typer.Option("--expression", help="An expression: smile, smile=0.7.")]
ChannelsOption = Annotated[list[str] | None, typer.Option("--channel", help="A channel over it: jawOpen=0.5.")]
LightOption = Annotated[str, typer.Option(help="theatre, portrait, flat or a mix: theatre=0.5+flat.")]
BackgroundOption = Annotated[str | None, typer.Option(help="A colour behind the head: #00b140.")]
TransparentOption = Annotated[bool, typer.Option("--transparent", help="Nothing behind the head.")]
QualityOption = Annotated[str, typer.Option(help="lowest, low, medium or high.")]

app = typer.Typer(
    help="Omote plays faces live: any face wears any expression, and both change at any instant.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.add_typer(file_app, name="file")


def main() -> None:
    """The `omote` command."""
    app()


@app.command()
def show(
    file: Annotated[Path | None, typer.Argument(help="The show file (.omote); made when there is none.")] = None,
    host: Annotated[str, typer.Option(help="The address to listen on; 0.0.0.0 for the whole network.")] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="The port to listen on; 0 for any.")] = 8090,
    browser: Annotated[bool, typer.Option("--open/--no-open", help="Open the stage and the console.")] = True,
) -> None:
    """Opens a show: serves stage and console, and keeps them alive."""
    if sys.platform == "win32":
        fail("omote show runs on Linux and macOS; on Windows use it inside WSL.")
    from omote.server.http.static_pages import read_pages
    from omote.server.persistence.lock import ShowLockedError, lock_show
    from omote.server.persistence.restore import open_newest
    from omote.server.process.notice_board import NoticeBoard
    from omote.server.supervision.supervisor import Supervisor, listen_on
    from omote.showfile.identification import locate_show
    from omote.showfile.show_file import ShowFileError, default_path

    board = NoticeBoard()
    try:
        path = locate_show(file or default_path())
        read_pages()
        lock = lock_show(path)
        listening = listen_on(host, port)  # before the file is made: a refused port leaves none
        open_newest(path, board.with_report(say)).close()
    except (OSError, ShowFileError, ShowLockedError) as error:
        fail_with(error)
    port = listening.getsockname()[1]
    opened = partial(announce, host, port, browser=browser)
    supervisor = Supervisor(listening, lock, path, report=say, opened=opened, notices=board.notices)
    say("the faces are getting ready ...")
    raise typer.Exit(supervisor.run())


@app.command()
def cast(json: Annotated[bool, typer.Option("--json", help="Print it for programs.")] = False) -> None:
    """Lists the faces and the expressions of the built-in cast."""
    loaded = load_cast()
    if json:
        print_json(loaded)
    else:
        print_table(loaded)


@app.command()
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
) -> None:
    """Draws one picture of a face, without a window, as the stage draws it."""
    words = {"turn": turn, "gaze": gaze, "light": light, "channels": "+".join(channel or [])}
    words |= {"face": "+".join(face or ["generic"]), "expression": "+".join(expression or [])}

    def sheet(cast: Cast) -> PictureGrid:
        from omote.stage_data.picture_grid import PictureGrid
        from omote.stage_data.pose_parser import parse_pose, pose_of

        return PictureGrid([[pose_of(cast, parse_pose(cast, **words))]])

    draw(output, sheet, size, background=background, transparent=transparent, quality=quality)


@app.command()
def grid(
    output: Output,
    faces: Annotated[str, typer.Option(help="The rows: faces, or mixes of them (kaori=0.5+dog=0.5), by commas.")],
    expressions: Annotated[str, typer.Option(help="The columns: expressions, or mixes, by commas.")] = "neutral",
    turns: Annotated[str, typer.Option(help="More columns: each expression at these yaws, degrees, by commas.")] = "0",
    labels: Annotated[bool, typer.Option("--labels/--no-labels", help="Write the names beside the pictures.")] = True,
    size: Annotated[str, typer.Option(help="Width x height of one picture, pixels.")] = "240x270",
    light: LightOption = "theatre",
    background: BackgroundOption = None,
    transparent: TransparentOption = False,
    quality: QualityOption = "high",
) -> None:
    """Draws pictures in rows and columns: faces by expressions, and by turns."""

    def sheet(cast: Cast) -> PictureGrid:
        from omote.stage_data.picture_grid import build_grid

        return build_grid(cast, faces=faces, expressions=expressions, turns=turns, light=light, labels=labels)

    draw(output, sheet, size, background=background, transparent=transparent, quality=quality)


@app.command()
def export(
    face: Annotated[str, typer.Argument(help="A face of the cast: kaori, dog.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The file to write: face.glb.")],
    expressions: Annotated[str, typer.Option(help="arkit, performed, makehuman, all, or names, by commas.")] = "arkit",
    hair: Annotated[bool, typer.Option("--hair/--no-hair", help="The face's hair, as ribbons.")] = True,
    show: Annotated[Path | None, typer.Option(help="A show file (.omote) whose own work can be named too.")] = None,
) -> None:
    """Writes a face with expressions as morph targets (GLB), for Blender, three.js, game engines."""
    from rich.console import Console
    from rich.progress import track

    from omote.builtin import load_mask, load_meshes
    from omote.interchange.export_face import ExportContext, build_scene, choose_expressions, named_compound_meshes
    from omote.interchange.formats.atomic_file import check_writable, write_whole
    from omote.interchange.formats.glb_writer import check_name, glb_bytes

    try:
        check_name(output)
        check_writable(output)
        cast = load_cast() if show is None else load_full_cast(show)
        names = choose_expressions(cast, expressions)
        busy = track(names, f"omote: {face}", console=Console(stderr=True), transient=True)
        poses = ((name, named_compound_meshes(cast, face, name)) for name in busy)
        write_whole(
            output, glb_bytes(build_scene(ExportContext(cast, load_meshes(), load_mask()), face, poses, hair=hair))
        )
    except (OSError, ValueError, RuntimeError) as error:
        fail_with(error)
    say(f"{output}: {face}, morph targets: {len(names)}, {output.stat().st_size / 1e6:.1f} MB")


@app.command()
def check() -> None:
    """Says whether this machine can play."""
    from omote.server.check import run_checks

    good = True
    for passed, sentence in run_checks():
        good = good and passed
        typer.echo(f"{'good' if passed else 'BAD '}  {sentence}")
    if not good:
        fail("this machine cannot play yet.")


def draw(output: Path, sheet_of: Callable[[Cast], PictureGrid], size: str, **setting: Any) -> None:
    """Renders a picture grid into a file, or ends the command with an error message and leaves no file behind."""
    from omote.interchange.formats.atomic_file import check_writable, write_whole
    from omote.interchange.formats.picture_names import picture_kind
    from omote.server.headless.devtools import BrowserError
    from omote.server.headless.picture_renderer import draw_grid
    from omote.stage_data.picture_grid import Setting, read_size

    try:
        kind = picture_kind(output)
        check_writable(output)
        width, height = read_size(size)
        chosen = Setting(width, height, **setting)
        write_whole(output, draw_grid(sheet_of(load_cast()).on_paper(chosen, kind), chosen))
    except (OSError, ValueError, BrowserError) as error:
        fail_with(error)


def announce(host: str, port: int, *, browser: bool) -> None:
    """Prints the addresses of the pages, and opens stage and console where there is a screen."""
    from omote.server.http.address import local_address, reachable_addresses

    for url in reachable_addresses(host, port):
        typer.echo(f"  stage    {url}/stage\n  console  {url}/console\n  editor   {url}/editor")
    if host not in ("127.0.0.1", "::1", "localhost"):
        say("everybody on this network can play; there is no password yet.")
    typer.echo("  Ctrl-C ends the show.")
    if browser and has_screen():
        for page in ("stage", "console"):
            webbrowser.open(f"{local_address(host, port)}/{page}")


def has_screen() -> bool:
    """Whether there is a screen on which a browser can open."""
    return sys.platform == "darwin" or bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def load_cast() -> Cast:
    """Loads the built-in cast; ends the command with an error message when it is missing."""
    from omote import builtin

    try:
        return builtin.load_cast()
    except (OSError, ValueError) as error:
        fail_with(error)


def load_full_cast(path: Path) -> Cast:
    """Loads the built-in cast with the own faces and expressions of a show file."""
    from omote.showfile.inspection import inspect_show
    from omote.stage_data.full_cast import build_full_cast

    found = inspect_show(path)
    return build_full_cast(load_cast(), found.stored, found.contents)


def print_json(cast: Cast) -> None:
    """Prints the cast as JSON."""
    import msgspec

    faces = [{"name": name, "vertices": len(face.positions)} for name, face in cast.faces.items()]
    titles = cast.titles
    expressions = [{"name": n, "kind": titles[n].kind, "region": titles[n].region} for n in cast.expressions]
    document = {"digest": cast.digest, "faces": faces, "expressions": expressions}
    typer.echo(msgspec.json.format(msgspec.json.encode(document), indent=2).decode())


def print_table(cast: Cast) -> None:
    """Prints the cast as a table, expressions grouped by kind."""
    from rich.console import Console
    from rich.table import Table

    table = Table(box=None, show_header=False, padding=(0, 2))
    table.add_row(f"[bold]{len(cast.faces)} faces", ", ".join(cast.faces))
    for kind in dict.fromkeys(title.kind for title in cast.titles.values()):
        names = [name for name in cast.expressions if cast.titles[name].kind == kind]
        table.add_row(f"[bold]{len(names)} {kind}", ", ".join(names))
    Console().print(table)


def say(sentence: str) -> None:
    """Prints a sentence on the operator's terminal."""
    typer.echo(f"omote: {sentence}", err=True)


def fail_with(error: Exception) -> NoReturn:
    """Ends the command with what an error means, in words."""
    from omote.showfile.database_errors import describe_error

    fail(describe_error(error))


def fail(sentence: str) -> NoReturn:
    """Ends the command with an error message and exit status 1."""
    say(sentence)
    raise typer.Exit(1)
