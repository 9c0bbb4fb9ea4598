"""The command `omote play-take`: plays a recording of a tracker into a running show."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from omote.terminal import exit_on_refusal, fail_with, say


def play_take(
    take: Annotated[Path, typer.Argument(help="A recording of Live Link Face (.csv).")],
    address: Annotated[
        str, typer.Option("--show", metavar="ADDRESS", help="The running show, as `omote show` prints it.")
    ] = "http://127.0.0.1:8090",
    character: Annotated[str, typer.Option(help="Whom it drives, by name or label; the first one without it.")] = "",
    layer: Annotated[str, typer.Option(help="The layer that it drives: playback, tracker, lips.")] = "playback",
    authority: Annotated[
        Path | None, typer.Option(help="What /certificate of a show with https gives, saved to a file (.pem).")
    ] = None,
    loop: Annotated[bool, typer.Option("--loop", help="Play it again and again, until Ctrl-C.")] = False,
) -> None:
    """Plays a recorded face into a running show."""
    from omote.inputs.takes.live_link_take import read_live_link_take
    from omote.perform.layers.layer_names import check_driven
    from omote.server.client.connect import connect
    from omote.server.client.take_player import play_take as play

    try:
        read = read_live_link_take(take.read_text(encoding="utf-8-sig"))
    except UnicodeDecodeError:
        fail_with(ValueError(f"{take} is no text of Live Link Face (.csv)"))
    except (OSError, ValueError) as error:
        fail_with(error if isinstance(error, OSError) else ValueError(f"{take}: {error}"))
    with exit_on_refusal(), connect(address, name="take", authority=authority) as show:
        drive = show[show.find_character(character or show.characters[0])].drive
        check_driven(layer)
        say(f"{take.name} plays: {len(read.times)} frames in {read.seconds:.1f} s.")
        while play(read, drive, layer=layer) and loop:
            pass
