"""The sockets of what plays a show, as the options of `omote show` ask for them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from omote.terminal import fail, fail_with, say

if TYPE_CHECKING:
    from omote.server.devices.osc_listener import OscSockets
    from omote.server.supervision.device_sockets import DeviceOptions, DeviceSockets

OSC_PORT = 9000
OFF = -1
COLUMN = len("microphone") + 2
"""Letters of the first column of what the start prints."""


def read_options(sacn: str, bindings: Path | None, allow: str, listen: str = "", send: str = "") -> DeviceOptions:
    """What the operator asks for of devices, validated; ends the command where it cannot be.

    sacn: universes; bindings: a file of them; allow: who may send; listen: trackers; send: receivers; all as they are
    typed.
    """
    from omote.inputs.allowed_senders import read_senders
    from omote.inputs.face_output.face_target import read_targets
    from omote.server.devices.trackers.tracker_sockets import find_phones, find_receivers, read_trackers
    from omote.server.supervision.device_sockets import DeviceOptions, read_universes

    try:
        wishes = find_phones(read_trackers(listen))
        targets = find_receivers(read_targets(send))
        universes = read_universes(sacn)
        if allow:
            read_senders(allow)
        if bindings is not None:
            from omote.server.supervision.device_sources import load_bindings

            load_bindings(bindings)
    except (OSError, ValueError) as error:
        fail_with(error)
    path = "" if bindings is None else str(bindings.resolve())
    words = ",".join(wish.word for wish in wishes)
    sent = ",".join(target.word for target in targets)
    for target in targets:
        if target.host.startswith("127.") and target.port in (wish.port for wish in wishes):
            fail(f"{target.word} would send the show its own face; name another port.")
    return DeviceOptions(universes=universes, allow=allow, bindings=path, listen=words, send=sent)


def open_devices(host: str, osc: int | None, options: DeviceOptions, artnet: int) -> DeviceSockets:
    """The sockets that were asked for; ends the command where one of OSC or of a desk cannot be had, and says which
    tracker is off. Without any (`OFF`, None for OSC at its usual port) there is none.

    host: where the show listens; osc, artnet: their ports; options: what else was asked for.
    """
    from omote.server.devices.trackers.tracker_sockets import listen_for_trackers, read_trackers
    from omote.server.supervision.device_sockets import DeviceSockets, listen_for_artnet, listen_for_sacn
    from omote.server.supervision.listening_socket import listen_for_osc

    try:
        return DeviceSockets(
            None if osc in (None, OFF) else listen_for_osc(host, osc or 0),
            listen_for_sacn(host, options.universes) if options.universes else None,
            None if artnet == OFF else listen_for_artnet(host, artnet),
            listen_for_trackers(read_trackers(options.listen), say),
        )
    except OSError as error:
        fail_with(error)


def list_others(options: DeviceOptions) -> list[str]:
    """A line for each tracker that has no socket of its own, and for each receiver of faces."""
    from omote.inputs.face_output.face_target import read_targets
    from omote.server.devices.trackers.tracker_sockets import explain_others, read_trackers

    return explain_others(read_trackers(options.listen), read_targets(options.send))


def open_usual_osc(host: str) -> OscSockets | None:
    """The sockets of OSC at its usual port; None, with a word, where another program has that."""
    from omote.server.supervision.listening_socket import listen_for_osc

    try:
        return listen_for_osc(host, OSC_PORT)
    except OSError as error:
        say(f"OSC is off: {error}")
        return None


def print_line(word: str, text: str) -> None:
    """Prints a line of the start: a word for what it is, and a text that says where; all in two columns."""
    typer.echo(f"  {word:<{COLUMN}}{text}")


def print_trackers(trackers: Sequence[str], allow: str, page: str = "", *, colour: bool = False) -> None:
    """Prints a line for each tracker that is heard, with what to do at its sender, and for each receiver of faces.

    page: the address where a phone copies what to type, with a picture that opens it, or ""; trackers: those lines;
    allow: who may send, as it is typed; colour: whether the terminal shows it.
    """
    for line in trackers:
        word, _, text = line.partition(" ")
        print_line(word, text.lstrip())
    heard = [line for line in trackers if line.startswith("tracker")]
    if heard and page:
        from omote.access_commands import read_code

        typer.echo(f"\n{read_code(page, colour=colour)}\n")
        typer.echo(f"  A phone that reads this picture opens what to type into its app:\n  {page}")
    if heard and not allow:
        from omote.server.access.show_addresses import own_network

        say(f"trackers on other machines and phones are not heard: --allow {own_network()} lets a network play.")
