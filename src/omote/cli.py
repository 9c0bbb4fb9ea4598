"""The command line (`omote`): each command only wires other modules, and imports heavy ones where they are used."""

from __future__ import annotations

import shutil
import sys
import textwrap
import webbrowser
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.file_commands import file_app
from omote.picture_commands import ShowOption, grid, redraw, render
from omote.terminal import complete_name, complete_show, exit_on_refusal, fail, fail_with, has_screen, say

if TYPE_CHECKING:
    from omote.interchange.export_face import Meshes
    from omote.model.cast import Cast
    from omote.server.devices.osc_listener import OscSockets
    from omote.showfile.inspection import Inspection

HIGHEST_PORT = 65535
OSC_PORT, OSC_OFF = 9000, -1

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.add_typer(file_app, name="file")


def print_version(wanted: bool) -> None:
    """Prints the version and ends the command, where that is asked for."""
    if wanted:
        from omote import __version__

        typer.echo(f"omote {__version__}")
        raise typer.Exit


@app.callback()
def omote(
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version, and end.")
    ] = False,
) -> None:
    """Omote plays faces live: any face wears any expression, and both change at any instant."""


def main() -> None:
    """The `omote` command."""
    app()


def read_osc_port(text: str | int) -> int:
    """The number of the port for OSC as it is typed; `OSC_OFF` for "off"."""
    return OSC_OFF if str(text).strip().lower() == "off" else read_port(text)


def read_port(text: str | int) -> int:
    """The number of a port as it is typed."""
    digits = str(text).strip()
    if not digits.isascii() or not digits.isdecimal() or int(digits[:9]) > HIGHEST_PORT:
        raise typer.BadParameter(
            f"{digits!r} is no port; give a number from 1 to {HIGHEST_PORT}, or 0 for any free one"
        )
    return int(digits)


@app.command()
def show(
    context: typer.Context,
    file: Annotated[
        Path | None, typer.Argument(callback=complete_show, help="The show file (.omote); made when there is none.")
    ] = None,
    host: Annotated[str, typer.Option(help="The address to listen on; 0.0.0.0 for the whole network.")] = "127.0.0.1",
    port: Annotated[
        int, typer.Option(parser=read_port, metavar="PORT", help="The port to listen on; 0 for any.")
    ] = 8090,
    osc: Annotated[
        int | None,
        typer.Option(
            parser=read_osc_port,
            metavar="PORT|off",
            help="The port for OSC, UDP and TCP; off for none. [default: 9000]",
        ),
    ] = None,
    browser: Annotated[bool, typer.Option("--open/--no-open", help="Open the stage and the console.")] = True,
) -> None:
    """Opens a show: serves stage and console, and keeps them alive."""
    if sys.platform == "win32":
        fail("omote show runs on Linux and macOS; on Windows use it inside WSL.")
    from omote.server.persistence.lock import ShowLockedError
    from omote.server.process.notice_board import NoticeBoard
    from omote.server.supervision.preparation import prepare_show
    from omote.server.supervision.supervisor import Supervisor
    from omote.showfile.identification import locate_show
    from omote.showfile.schema import ShowFileError

    board = NoticeBoard()
    sockets = None if osc is None else open_osc(context, host, osc)
    try:
        path = locate_show(default_show() if file is None else file)
        lock, listening = prepare_show(path, host, port, tell=say, report=board.with_report(say))
    except (OSError, ShowFileError, ShowLockedError) as error:
        fail_with(error)
    port = listening.getsockname()[1]
    sockets = open_osc(context, host, None) if osc is None else sockets
    opened = partial(announce, host, port, browser=browser, osc=sockets)
    handed = {} if sockets is None else sockets.handed
    supervisor = Supervisor(listening, lock, path, report=say, opened=opened, notices=board.notices, handed=handed)
    say("the faces are getting ready ...")
    raise typer.Exit(supervisor.run())


def open_osc(context: typer.Context, host: str, port: int | None) -> OscSockets | None:
    """The sockets of OSC until the command ends; None for `OSC_OFF`, and where another program has the usual port and
    nobody named one. Ends the command where a named one cannot be had."""
    from omote.server.supervision.listening_socket import listen_for_osc

    if port == OSC_OFF:
        return None
    try:
        sockets = listen_for_osc(host, OSC_PORT if port is None else port)
    except OSError as error:
        if port is not None:
            fail_with(error)
        say(f"OSC is off: {error}")
        return None
    context.call_on_close(sockets.close)
    return sockets


def default_show() -> Path:
    """The show file where none is named, in a folder that is made for it."""
    from omote.showfile.show_file import default_path

    path = default_path()
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


@app.command()
def cast(json: Annotated[bool, typer.Option("--json", help="Print it for programs.")] = False) -> None:
    """Lists the faces and the expressions of the built-in cast."""
    loaded = load_cast()
    if json:
        print_json(loaded)
    else:
        print_table(loaded)


app.command()(render)
app.command()(grid)
app.command()(redraw)


@app.command()
def export(
    face: Annotated[str, typer.Argument(help="A face of the cast: kaori, dog.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The file to write: face.glb, face.npz, face.csv.")],
    expressions: Annotated[
        str,
        typer.Option(
            help="arkit, performed, makehuman, omote, own, all, neutral (the face alone), or names, by commas."
        ),
    ] = "arkit",
    hair: Annotated[bool, typer.Option("--hair/--no-hair", help="The face's hair, as ribbons.")] = True,
    show: ShowOption = None,
    force: Annotated[bool, typer.Option("--force", help="Replaces a file that is there.")] = False,
) -> None:
    """Writes a face with expressions: as morph targets (GLB), or as what each moves in numbers (NPZ, CSV)."""
    output = complete_name(output, ".glb")
    found = check_export(output, show, force=force)
    from rich.console import Console  # what is heavy comes after what can be refused without it
    from rich.progress import track

    from omote.interchange.export_face import choose_expressions, named_compound_meshes
    from omote.interchange.formats.atomic_file import write_whole
    from omote.stage_data.full_cast import build_full_cast, find_face

    with exit_on_refusal():
        encode = find_encoder(output, hair=hair)
        cast = load_cast() if found is None else build_full_cast(load_cast(), found.stored, found.contents)
        face = find_face(cast, None if found is None else found.stored, face)
        names = choose_expressions(cast, expressions)
        busy = track(names, f"omote: {face}", console=Console(stderr=True), transient=True)
        poses = ((name, named_compound_meshes(cast, face, name)) for name in busy)
        write_whole(output, encode(cast, face, poses))
    what = "morph targets" if output.suffix.lower() == ".glb" else "expressions"
    say(f"{output}: {face}, {what}: {len(names)}, {output.stat().st_size / 1e6:.1f} MB")


def check_export(output: Path, show: Path | None, *, force: bool) -> Inspection | None:
    """What the show file holds, if one is named; ends the command where the export could not be written."""
    from omote.interchange.formats.atomic_file import check_writable, require_free
    from omote.interchange.formats.file_names import check_export_name
    from omote.showfile.inspection import inspect_show

    with exit_on_refusal():
        check_export_name(output)
        check_writable(output)
        require_free(output, force=force)
        return None if show is None else inspect_show(show)


def find_encoder(path: Path, *, hair: bool) -> Callable[[Cast, str, Iterable[tuple[str, Meshes]]], bytes]:
    """What makes the bytes of an exported face, by the file's ending."""
    from omote.builtin import load_mask, load_meshes
    from omote.interchange.export_deltas import encode_deltas, measure_deltas
    from omote.interchange.export_face import ExportContext, build_scene
    from omote.interchange.formats.file_names import GLB
    from omote.interchange.formats.glb_writer import glb_bytes

    if path.suffix.lower() != GLB:
        return lambda cast, face, poses: encode_deltas(measure_deltas(cast, face, poses), path)

    def encode(cast: Cast, face: str, poses: Iterable[tuple[str, Meshes]]) -> bytes:
        return glb_bytes(build_scene(ExportContext(cast, load_meshes(), load_mask()), face, poses, hair=hair))

    return encode


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


def announce(host: str, port: int, *, browser: bool, osc: OscSockets | None = None) -> None:
    """Prints the addresses of the pages and of OSC, and opens stage and console where there is a screen."""
    from omote.server.http.address import local_address, reachable_addresses

    for url in reachable_addresses(host, port):
        typer.echo(f"  stage    {url}/stage\n  console  {url}/console\n  editor   {url}/editor")
    if osc is not None:
        typer.echo(f"  OSC      port {osc.datagrams.getsockname()[1]}")
    if host not in ("127.0.0.1", "::1", "localhost"):
        say("everybody on this network can play; there is no password yet.")
    typer.echo("  Ctrl-C ends the show.")
    if browser and has_screen():
        for page in ("stage", "console"):
            webbrowser.open(f"{local_address(host, port)}/{page}")


def load_cast() -> Cast:
    """Loads the built-in cast; ends the command with an error message when it is missing."""
    from omote import builtin

    try:
        return builtin.load_cast()
    except (OSError, ValueError) as error:
        fail_with(error)


def print_json(cast: Cast) -> None:
    """Prints the cast as JSON."""
    import msgspec

    from omote.model.action_units import action_units

    faces = [{"name": name, "vertices": len(face.positions)} for name, face in cast.faces.items()]
    titles = cast.titles
    expressions = [{"name": n, **asdict(titles[n]), "facs": action_units(n)} for n in cast.expressions]
    document = {"digest": cast.digest, "faces": faces, "expressions": expressions}
    typer.echo(msgspec.json.format(msgspec.json.encode(document), indent=2).decode())


def print_table(cast: Cast) -> None:
    """Prints the cast for people, expressions grouped by kind."""
    print_names(f"{len(cast.faces)} faces", dict.fromkeys(cast.faces, ""))
    for kind in dict.fromkeys(title.kind for title in cast.titles.values()):
        labels = {name: title.label for name, title in cast.titles.items() if title.kind == kind}
        print_names(f"{len(labels)} {kind}", labels)


def print_names(heading: str, labels: Mapping[str, str]) -> None:
    """Prints names under a heading, none cut: with its label a line each, else as many on a line as there is room."""
    typer.secho(heading, bold=True)
    widest = max(map(len, labels), default=0)
    told = {name: label for name, label in labels.items() if label.lower() not in ("", name)}
    for name, label in told.items():
        typer.echo(f"  {name:<{widest}}  {label}")
    rest, width = ", ".join(name for name in labels if name not in told), max(40, shutil.get_terminal_size().columns)
    for line in textwrap.wrap(rest, width - 2, break_long_words=False, break_on_hyphens=False):
        typer.echo(f"  {line}")
