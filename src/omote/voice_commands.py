"""The command `omote voice`: the synthetic voices of this machine, and models of Piper among them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from omote.terminal import escape_controls, exit_on_refusal, say


def voice(
    models: Annotated[
        list[Path] | None, typer.Argument(help="Models of Piper (.onnx beside its .onnx.json) to keep as voices.")
    ] = None,
) -> None:
    """Keeps models of Piper as voices of this machine; without one, lists the voices that there are."""
    from omote.inputs.voices.spoken_text import HOW_TO_GET_A_VOICE
    from omote.server.sandbox.piper_models import keep_model, models_folder
    from omote.server.sandbox.voices import list_voices

    with exit_on_refusal():
        for model in models or []:
            typer.echo(keep_model(model))
            say(f"{model.name} speaks, and is kept in {models_folder()}; delete it there to be rid of it.")
        if models:
            return
        voices = list_voices()
    for each in voices:
        typer.echo(f"{escape_controls(each.name)}\t{escape_controls(each.label)}")
    if not voices:
        say(f"this machine has no voice; {HOW_TO_GET_A_VOICE}.")
