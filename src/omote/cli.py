"""The command line (`omote`): each command only wires other modules, and imports heavy ones where they are used."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.access_commands import access_app
from omote.agent_commands import mcp
from omote.camera_commands import body_model, track
from omote.clip_commands import clip_app
from omote.export_commands import export
from omote.face_commands import draw_random, face
from omote.file_commands import file_app
from omote.picture_commands import grid, redraw, render
from omote.recording_commands import recording_app, replay
from omote.show_command import show
from omote.stimulus_commands import stimuli
from omote.take_commands import play_take, record_take
from omote.terminal import complete_show, fail, fail_with
from omote.voice_commands import voice

if TYPE_CHECKING:
    from omote.model.cast import Cast

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
app.add_typer(clip_app, name="clip")
app.add_typer(file_app, name="file")
app.add_typer(access_app, name="access")
app.add_typer(recording_app, name="recording")


def print_version(wanted: bool) -> None:
    """Prints the version and ends the command, where that is asked for."""
    if wanted:
        from omote import __version__

        typer.echo(f"omote {__version__}")
        raise typer.Exit


@app.callback(help="Omote plays faces live: any face wears any expression, and both change at any instant.")
def omote(
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version, and end.")
    ] = False,
) -> None:
    """Prints the version, where that is asked for; all else is a command's."""


app.command()(show)


def main() -> None:
    """Runs the command `omote`."""
    app()


@app.command()
def cast(
    json: Annotated[bool, typer.Option("--json", help="Print it for programs.")] = False,
    random: Annotated[
        int | None,
        typer.Option(min=1, max=1000, metavar="COUNT", help="Instead: so many new faces of nobody into -o show.omote."),
    ] = None,
    seed: Annotated[
        int | None, typer.Option(min=0, help="Of the new faces: the same seed, the same faces; else 0.")
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", callback=complete_show, help="The show file (.omote) that gets the new faces."),
    ] = None,
) -> None:
    """Lists the faces and the expressions of the built-in cast, or draws new faces at random."""
    if random is not None:
        draw_random(output, random, seed or 0, json=json)
        return
    if seed is not None or output is not None:
        fail("--seed and -o are of new faces; add --random COUNT.")
    loaded = load_cast()
    if json:
        print_json(loaded)
    else:
        print_table(loaded)


app.command()(face)
app.command()(render)
app.command()(grid)
app.command()(redraw)
app.command()(stimuli)
app.command()(export)
app.command("play-take")(play_take)
app.command()(track)
app.command("body-model")(body_model)
app.command("record-take")(record_take)
app.command()(replay)
app.command()(voice)
app.command()(mcp)


@app.command("say", hidden=True, context_settings={"ignore_unknown_options": True, "allow_extra_args": True})
def refuse_say() -> None:
    """Says what makes a face speak: no command does."""
    fail(
        'no command speaks: a program does, omote.connect("http://127.0.0.1:8090")["one"].say("Hello") '
        "(docs/howto/speech.md), and the console, under Layers."
    )


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
    """Prints names under a heading, none cut: with its label a line each, else as many on a line as there is room.

    labels: the label of each name, or "".
    """
    typer.secho(heading, bold=True)
    widest = max(map(len, labels), default=0)
    labelled = {name: label for name, label in labels.items() if label.lower() not in ("", name)}
    for name, label in labelled.items():
        typer.echo(f"  {name:<{widest}}  {label}")
    rest = ", ".join(name for name in labels if name not in labelled)
    width = max(40, shutil.get_terminal_size().columns)
    for line in textwrap.wrap(rest, width - 2, break_long_words=False, break_on_hyphens=False):
        typer.echo(f"  {line}")
