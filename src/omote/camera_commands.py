"""The commands `omote track` and `omote body-model`: cameras of performers, and the model by which bodies are found."""

from __future__ import annotations

import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from omote.terminal import exit_on_refusal, fail_with, say


def track(
    to: Annotated[
        str, typer.Option("--to", metavar="HOST[:PORT]", help="The show, by name, address, or as omote show prints it.")
    ],
    token: Annotated[str | None, typer.Option(help="Of a show that asks for one; its role is operate.")] = None,
    authority: Annotated[
        Path | None, typer.Option(help="What /certificate of a show with https gives, saved to a file (.pem).")
    ] = None,
    port: Annotated[int, typer.Option(min=0, max=65535, help="Of the page on this machine; 0: any.")] = 8095,
    open_page: Annotated[bool, typer.Option("--open/--no-open", help="Opens the page in the browser.")] = True,
) -> None:
    """Plays a show elsewhere by the camera of this machine."""
    from omote.server.camera import track_server

    def announce(page: str, reason: str) -> None:
        say(
            f"{reason}. The page tries again by itself."
            if reason
            else f"the show at {target.address} hears this machine."
        )
        say(f"the camera page: {page} (Ctrl-C ends)")
        if open_page:
            webbrowser.open(page)

    try:
        target = track_server.find_target(to, token, authority)
    except (OSError, ValueError) as error:
        fail_with(error)
    with exit_on_refusal():
        track_server.track(target, port, announce)


def body_model(
    package: Annotated[Path, typer.Argument(metavar="PACKAGE.TGZ", help="Of npm: npm pack @mediapipe/pose.")],
) -> None:
    """Puts the model that finds bodies before a camera into an installed Omote; a checkout has it."""
    from omote.server.camera.body_model import install_body_model
    from omote.server.http.static_pages import FOLDER

    try:
        folder = install_body_model(package, FOLDER / "static")
    except (OSError, ValueError) as error:
        fail_with(error)
    say(f"bodies are found from now on by the model in {folder}; load the camera page again.")
