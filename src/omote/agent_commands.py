"""The command `omote mcp`: a running show as tools of the Model Context Protocol."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Annotated

import typer

from omote.terminal import exit_on_refusal, fail, say

NEEDED = "agents are served by the package `mcp`, which is not here: pip install 'omote[agents]'"


def mcp(
    address: Annotated[
        str, typer.Option("--show", metavar="ADDRESS", help="The running show, as `omote show` prints it.")
    ] = "http://127.0.0.1:8090",
    token: Annotated[
        str | None, typer.Option(help="Of a show that asks for one: its role says which tools the agent has.")
    ] = None,
    authority: Annotated[
        Path | None, typer.Option(help="What /certificate of a show with https gives, saved to a file (.pem).")
    ] = None,
    preview: Annotated[
        bool, typer.Option("--preview", help="Play the preview, which a person takes on air, and not what is on air.")
    ] = False,
    width: Annotated[int, typer.Option(min=160, max=1920, help="Of its pictures, pixels.")] = 768,
    height: Annotated[int, typer.Option(min=160, max=1920, help="Of its pictures, pixels.")] = 432,
) -> None:
    """Serves a running show to an agent: its commands as tools of the Model Context Protocol, over standard input."""
    if find_spec("mcp") is None:
        fail(NEEDED)
    from omote.server.agents.tool_server import serve

    with exit_on_refusal():
        say(f"an agent plays the show at {address} while this command runs.")
        serve(address, token=token, authority=authority, bus="preview" if preview else "air", size=(width, height))
