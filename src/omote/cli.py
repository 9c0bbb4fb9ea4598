"""The command line (`omote`): each command only wires other modules, and imports heavy ones where they are used."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.access_commands import access_app
from omote.camera_commands import track
from omote.face_commands import face
from omote.file_commands import file_app
from omote.picture_commands import ShowOption, grid, redraw, render
from omote.show_command import show
from omote.take_commands import play_take, record_take
from omote.terminal import complete_name, exit_on_refusal, fail, fail_with, say

if TYPE_CHECKING:
    from omote.interchange.export_face import Meshes
    from omote.model.cast import Cast
    from omote.showfile.inspection import Inspection

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.add_typer(file_app, name="file")
app.add_typer(access_app, name="access")


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


app.command()(show)


def main() -> None:
    """The `omote` command."""
    app()


@app.command()
def cast(json: Annotated[bool, typer.Option("--json", help="Print it for programs.")] = False) -> None:
    """Lists the faces and the expressions of the built-in cast."""
    loaded = load_cast()
    if json:
        print_json(loaded)
    else:
        print_table(loaded)


app.command()(face)
app.command()(render)
app.command()(grid)
app.command()(redraw)
app.command("play-take")(play_take)
app.command()(track)
app.command("record-take")(record_take)


@app.command("say", hidden=True, context_settings={"ignore_unknown_options": True, "allow_extra_args": True})
def refuse_say() -> None:
    """Says what makes a face speak: no command does."""
    fail(
        'no command speaks: a program does, omote.connect("http://127.0.0.1:8090")["one"].say("Hello") '
        "(docs/howto/speech.md), and the console, under Layers."
    )


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
        cast = load_cast() if found is None else build_full_cast(load_cast(), found.stored, found.contents, say)
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
