"""The command `omote show`: opens the sockets of a show, and has it played and announce_beside."""

from __future__ import annotations

import contextlib
import sys
import webbrowser
from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.access_commands import has_colour, note_place, print_shared
from omote.show_sockets import (
    OFF,
    list_others,
    open_devices,
    open_usual_osc,
    print_line,
    print_trackers,
    read_options,
)
from omote.terminal import complete_show, fail, fail_with, has_screen, say

if TYPE_CHECKING:
    from omote.server.access.access_setup import AccessOptions
    from omote.server.access.certificates import CertificateFiles
    from omote.server.devices.osc_listener import OscSockets
    from omote.server.process.notice_board import NoticeBoard
    from omote.server.supervision.preparation import Prepared
    from omote.show.access.people_list import People

HIGHEST_PORT = 65535
PAGES = "stage", "console", "solo", "cues", "clips", "notes", "runs", "editor", "camera", "microphone", "devices"
"""What a browser opens of a show, as the start lists it."""


def read_port_or_off(text: str | int) -> int:
    """The number of a port as it is typed; `OFF` for "off"."""
    return OFF if str(text).strip().lower() == "off" else read_port(text)


def read_port(text: str | int) -> int:
    """The number of a port as it is typed."""
    digits = str(text).strip()
    if not digits.isascii() or not digits.isdecimal() or int(digits[:9]) > HIGHEST_PORT:
        raise typer.BadParameter(
            f"{digits!r} is no port; give a number from 1 to {HIGHEST_PORT}, or 0 for any free one"
        )
    return int(digits)


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
            parser=read_port_or_off,
            metavar="PORT|off",
            help="The port for OSC, UDP and TCP; off for none; 9000 without it.",
        ),
    ] = None,
    sacn: Annotated[
        str, typer.Option(metavar="UNIVERSES|off", help="Universes of sACN (E1.31) to hear: 1,3-5.")
    ] = "off",
    artnet: Annotated[
        int | None,
        typer.Option(
            parser=read_port_or_off,
            metavar="PORT|off",
            help="The port for Art-Net, usually 6454; off without it.",
        ),
    ] = None,
    bindings: Annotated[
        Path | None, typer.Option(help="What controls of devices play (.toml), before what pages have bound.")
    ] = None,
    listen: Annotated[
        str,
        typer.Option(
            metavar="TRACKERS", help="Face trackers to hear: vmc,livelink,ifacialmocap@PHONE,openseeface:PORT."
        ),
    ] = "",
    send: Annotated[
        str,
        typer.Option(metavar="RECEIVERS", help="Where the face on air is sent: vmc:HOST:PORT,livelink:HOST,osc:HOST."),
    ] = "",
    show_control: Annotated[
        int,
        typer.Option(
            metavar="DEVICE", min=0, max=111, help="The device that this show is for MIDI Show Control; 127 means all."
        ),
    ] = 0,
    record: Annotated[
        bool, typer.Option("--record/--no-record", help="Record what the show does beside its file; see omote replay.")
    ] = True,
    allow: Annotated[
        str,
        typer.Option(metavar="NETWORKS", help="Who may send beside this machine: 192.168.1.0/24,10.0.0.7 or any."),
    ] = "",
    find: Annotated[
        bool, typer.Option("--announce/--no-announce", help="Let control surfaces find the show (mDNS).")
    ] = True,
    https: Annotated[
        bool, typer.Option("--https", help="Serve over https with a certificate made on the spot.")
    ] = False,
    certificate: Annotated[
        Path | None, typer.Option(help="Serve over https with a certificate of your own (.pem).")
    ] = None,
    key: Annotated[Path | None, typer.Option(help="The key of that certificate (.pem), without a password.")] = None,
    embed: Annotated[
        list[str] | None,
        typer.Option(metavar="ORIGIN", help="A site whose pages may show a stage in a frame: https://museum.example."),
    ] = None,
    browser: Annotated[bool, typer.Option("--open/--no-open", help="Open the stage and the console.")] = True,
) -> None:
    """Opens a show: serves stage and console, and keeps them alive."""
    refuse_windows()
    from omote.server.process.terminal_relay import relay_terminal
    from omote.server.supervision.supervisor import PROGRAM, Supervisor

    options = replace(read_options(sacn, bindings, allow, listen, send), show_control=show_control, recorded=record)
    embedders = read_embedders(embed or [])
    tls = open_certificate(host, certificate, key, made=https)
    devices = open_devices(host, osc, options, OFF if artnet is None else artnet)
    context.call_on_close(devices.close)
    path, (lock, listening), board = prepare(file, host, port)
    if osc is None:
        devices = replace(devices, osc=open_usual_osc(host))
        context.call_on_close(devices.close)
    context.call_on_close(listening.close)
    address, port = listening.getsockname()[:2]
    scheme = note_place(lock, host, port, secure=tls is not None)
    people, access = open_access(path, address, tls)
    stack = context.with_resource(contextlib.ExitStack())
    opened = partial(
        announce, host, port, browser=browser, colour=has_colour(), osc=devices.osc, find=path.stem if find else None
    )
    opened = partial(opened, stack=stack, allow=allow, people=people, scheme=scheme)
    opened = partial(opened, heard=devices.heard, trackers=devices.advice + list_others(options))
    words = (*PROGRAM, *options.words, *replace(access, embed=embedders).words)
    handed = devices.handed
    supervisor = Supervisor(
        listening, lock, path, report=say, opened=opened, program=words, notices=board.notices, handed=handed
    )
    with relay_terminal():
        say("the faces are getting ready ...")
        status = supervisor.run()
    if status == 0:
        say(tell_end(path))
    raise typer.Exit(status)


def tell_end(path: Path) -> str:
    """That a show has ended, and where it is kept. path: of its file, which may have gone."""
    if not path.is_file():
        return "the show has ended."
    return f"the show has ended; all that was authored and was on air is kept in {path}: omote show {path} goes on."


def refuse_windows() -> None:
    """Ends the command where a show cannot run."""
    if sys.platform == "win32":
        fail("omote show runs on Linux and macOS; on Windows use it inside WSL.")


def prepare(file: Path | None, host: str, port: int) -> tuple[Path, Prepared, NoticeBoard]:
    """The show file, its lock, the listening socket, and what the crew is to know; ends the command where one of them
    cannot be.

    host, port: where the show listens.
    """
    from omote.server.persistence.lock import ShowLockedError
    from omote.server.process.notice_board import NoticeBoard
    from omote.server.supervision.preparation import prepare_show
    from omote.showfile.identification import locate_show
    from omote.showfile.schema import ShowFileError

    board = NoticeBoard()
    try:
        path = locate_show(default_show() if file is None else file)
        return path, prepare_show(path, host, port, tell=say, report=board.with_report(say)), board
    except (OSError, ShowFileError, ShowLockedError) as error:
        fail_with(error)


def default_show() -> Path:
    """The show file where none is named, in a folder that is made for it."""
    from omote.showfile.show_file import default_path

    path = default_path()
    path.parent.mkdir(parents=True, exist_ok=True)
    return path


def open_certificate(host: str, certificate: Path | None, key: Path | None, *, made: bool) -> CertificateFiles | None:
    """What the show is to speak https with, made on the spot or of the operator's own; None for http. Ends the command
    where it is of no use.

    host: the name that it is for; certificate, key: the operator's own files.
    """
    from omote.server.access.certificates import CertificateFiles, load_context, make_usual_certificate

    if (certificate is None) != (key is None):
        fail("--certificate and --key belong together: name both, or --https for a certificate that is made here.")
    if certificate is None and not made:
        return None
    try:
        if certificate is not None and key is not None:
            files = CertificateFiles(certificate.resolve(), key.resolve())
        else:
            files = make_usual_certificate(host)
        load_context(files)
    except (OSError, ValueError) as error:
        fail_with(error)
    return files


def read_embedders(origins: Sequence[str]) -> str:
    """The origins of pages that may show a stage, by spaces; ends the command where one is none."""
    from omote.server.access.security import check_embedder

    try:
        return " ".join(dict.fromkeys(check_embedder(origin) for origin in origins))
    except ValueError as error:
        fail_with(error)


def open_access(show: Path, address: str, tls: CertificateFiles | None) -> tuple[People | None, AccessOptions]:
    """Who may play, None where only this machine reaches the show, and what its servers are told of that and of https;
    ends the command where the list cannot be used. address: where the show listens; tls: what it speaks https with."""
    from omote.server.access.access_setup import AccessOptions
    from omote.server.access.people_file import open_people, people_path
    from omote.server.access.show_addresses import is_loopback

    names = (tls.certificate, tls.key, tls.authority) if tls is not None else (None, None, None)
    written = ["" if name is None else str(name) for name in names]
    if is_loopback(address):
        return None, AccessOptions("", *written)
    try:
        people = open_people(people_path(show))
    except (OSError, ValueError) as error:
        fail_with(error)
    return people, AccessOptions(str(people_path(show)), *written)


def announce(
    host: str,
    port: int,
    *,
    browser: bool,
    colour: bool = False,
    osc: OscSockets | None = None,
    find: str | None = None,
    stack: contextlib.ExitStack | None = None,
    allow: str = "",
    people: People | None = None,
    scheme: str = "http",
    heard: Sequence[str] = (),
    trackers: Sequence[str] = (),
) -> None:
    """Prints the addresses of the pages, with tokens where the show asks for them, and of OSC; opens stage and console
    where there is a screen, and announces the show to surfaces under the name `find` until `stack` is closed.

    host, port: where the show listens; browser: whether pages open; colour: whether the terminal shows it; osc: its
    sockets; allow: who may send; people: who may enter; scheme: http or https; heard: protocols that ask for no token;
    trackers: a line for each.
    """
    from omote.server.access.show_addresses import local_address, own_entries, reachable_addresses

    addresses = reachable_addresses(host, port, scheme)
    print_pages(addresses, people, colour=colour)
    if osc is not None:
        number = osc.datagrams.getsockname()[1]
        print_line("OSC", f"port {number}")
        if find is not None and stack is not None:
            start_announcement(stack, host, port, number, find)
    print_trackers(trackers, allow, phone_address(people, addresses[-1]), colour=colour)
    if people is not None:
        say_who_is_heard(allow, heard)
    typer.echo("  Ctrl-C ends the show.")
    if browser and has_screen():
        for page in own_entries(local_address(host, port, scheme), people):
            webbrowser.open(page)


def print_pages(addresses: Sequence[str], people: People | None, *, colour: bool) -> None:
    """Prints the address of each page; where the show asks for tokens, the addresses by which people enter.

    addresses: of this machine; people: who may enter, None for all; colour: whether the terminal shows it.
    """
    if people is not None:
        print_shared(people, addresses[-1], colour=colour)
        return
    for url in addresses:
        for page in PAGES:
            print_line(page, f"{url}/{page}")


def phone_address(people: People | None, base: str) -> str:
    """Where a phone reads what to type into a tracker's app; "" where only this machine reaches the show.

    people: who may enter; base: the show's address.
    """
    from omote.server.access.phone_page import PHONE_PATH, goal_address

    return "" if people is None else goal_address(base, PHONE_PATH, "view", people)


def say_who_is_heard(allow: str, heard: Sequence[str]) -> None:
    """Says whose OSC, sACN and Art-Net play, which ask for no token; heard: those of them that are on; allow: the
    networks, as they are typed."""
    from omote.server.access.show_addresses import own_network

    if not heard:
        return
    what = f"{' and '.join(heard)} {'is' if len(heard) == 1 else 'are'} heard from this machine"
    say(
        f"{what} and from {allow}, without a token."
        if allow
        else f"{what} alone: --allow {own_network()} lets a network play."
    )


def start_announcement(stack: contextlib.ExitStack, host: str, port: int, osc: int, show: str) -> None:
    """Announces the show beside it until the stack is closed; the show goes on where that cannot be.

    host, port: where the show listens; osc: the port of OSC.
    """
    from omote.interchange.formats.error_reasons import explain_error
    from omote.server.devices.announcement import announce_beside

    try:
        stack.enter_context(announce_beside(host, port, osc, show))
    except OSError as error:
        say(f"surfaces do not find the show by themselves ({explain_error(error)}).")
