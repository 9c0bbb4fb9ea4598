"""Opens the sockets of trackers: what the operator types after `--listen`, one socket of UDP for each protocol."""

from __future__ import annotations

import errno
import socket
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

from omote.inputs.face_output.face_target import SEND_TITLES, FaceTarget
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, TrackerProtocol, advise
from omote.interchange.formats.error_reasons import explain_error
from omote.perform.limits import check_known
from omote.server.access.show_addresses import own_address

HIGHEST_PORT = 65535
OPTION = "--tracker-"
"""What stands before a protocol's name in the option of a standby that takes its socket."""


@dataclass(frozen=True)
class TrackerWish:
    """A protocol that is to be heard, at a port of ours, or of a program's. phone: the address of a phone that is asked
    for frames, of a sender that may play, or of the program, or ""."""

    protocol: TrackerProtocol
    port: int | None
    phone: str = ""

    @property
    def word(self) -> str:
        """The wish as it is typed."""
        port = "" if self.port is None else f":{self.port}"
        return f"{self.protocol.name}{port}" + (f"@{self.phone}" if self.phone else "")


def read_trackers(text: str) -> tuple[TrackerWish, ...]:
    """The protocols of a list as it is typed, `vmc,livelink:11112,ifacialmocap@192.168.1.30`; none for ""; ValueError
    with what is wrong."""
    wishes = [read_wish(word.strip()) for word in text.split(",")] if text.strip() else []
    names = [wish.protocol.name for wish in wishes]
    if len(set(names)) != len(names):
        raise ValueError(f"{text[:80]!r} names a tracker twice; name each once")
    return tuple(wishes)


def read_wish(word: str) -> TrackerWish:
    """One of them, `ifacialmocap:49983@192.168.1.30`; ValueError with what is wrong."""
    where, at, phone = word.partition("@")
    name, colon, port = where.partition(":")
    protocol = TRACKER_PROTOCOLS[check_known(name.strip().lower(), TRACKER_PROTOCOLS, "tracker")]
    if at and protocol.port is None:
        raise ValueError(f"{protocol.title} names nobody; write {name} without @{phone[:40]}")
    if at and not phone.strip():
        raise ValueError(f"{word[:60]!r} names nobody; give its address, such as {name}@192.168.1.30")
    if colon and protocol.port is None:
        raise ValueError(f"{protocol.title} comes to the port of the pages; write {name} without :{port[:10]}")
    if colon and not (port.isascii() and port.isdecimal() and int(port[:9]) <= HIGHEST_PORT):
        raise ValueError(
            f"the port of {word[:60]!r} is {port[:10] or 'left out'}; give a number from 0 to {HIGHEST_PORT}, such as "
            f"{name}:{protocol.port}"
        )
    return TrackerWish(protocol, int(port) if colon else protocol.port, phone.strip())


def find_phones(wishes: Iterable[TrackerWish]) -> tuple[TrackerWish, ...]:
    """The same with phones by their numeric addresses; OSError with a message where one has none."""
    return tuple(replace(wish, phone=find_host(wish.phone)) if wish.phone else wish for wish in wishes)


def find_receivers(targets: Iterable[FaceTarget]) -> tuple[FaceTarget, ...]:
    """The same with receivers by their numeric addresses, which no tick looks up; OSError with a message where one has
    none."""
    return tuple(replace(target, host=find_host(target.host)) for target in targets)


def find_host(name: str) -> str:
    """The numeric address of a host; OSError with a message where it has none."""
    try:
        return socket.gethostbyname(name)
    except (OSError, UnicodeError) as error:
        raise OSError(f"no address of {name[:60]} is known: type the one of its network settings.") from error


def listen_for_trackers(
    wishes: Iterable[TrackerWish], report: Callable[[str], None] = lambda _: None
) -> dict[str, socket.socket]:
    """A socket for each protocol, by its name, without those that cannot be had, of which `report` is told: no stage
    stays dark for a tracker. They are bound to all addresses: who is heard, the list of allowed senders decides.

    wishes: the trackers that were asked for.
    """
    opened: dict[str, socket.socket] = {}
    for wish in (wish for wish in wishes if wish.protocol.heard):
        try:
            opened[wish.protocol.name] = open_tracker(wish)
        except OSError as error:
            report(f"{wish.protocol.title} is off: {error} The page Devices switches it on later.")
    return opened


def open_tracker(wish: TrackerWish) -> socket.socket:
    """The socket of one that is heard; OSError with a message where it cannot be had."""
    stream = wish.protocol.stream
    datagrams = socket.socket(socket.AF_INET, socket.SOCK_STREAM if stream else socket.SOCK_DGRAM)
    port = wish.port or 0
    try:
        if stream:
            datagrams.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # connections of a show before linger
        datagrams.bind(("", port))
        if stream:
            datagrams.listen()
    except OSError as error:
        datagrams.close()
        taken = "another program has it" if error.errno == errno.EADDRINUSE else explain_error(error)
        raise OSError(
            f"port {port} cannot be opened for {wish.protocol.title} ({taken}): end that, or name another, "
            f"--listen {wish.protocol.name}:{port + 1}."
        ) from error
    return datagrams


def explain_others(wishes: Iterable[TrackerWish], targets: Iterable[FaceTarget]) -> list[str]:
    """A line for each tracker that has no socket here, and for each receiver of faces.

    wishes: the trackers that were asked for; targets: the receivers.
    """
    heard = [
        f"tracker  {wish.protocol.title}: {advise(wish.protocol, '', None)}"
        for wish in wishes
        if not wish.protocol.heard
    ]
    sent = [
        f"sends    {SEND_TITLES[target.protocol]} at {target.host}:{target.port}: "
        f"{target.character or 'the first character'}"
        for target in targets
    ]
    return heard + sent


def explain_trackers(sockets: Mapping[str, socket.socket]) -> list[str]:
    """A line for each protocol that is heard: its port, and what to do at the sender."""
    return [
        f"tracker  {protocol.title}: port {port}; {advise(protocol, own_address() or '127.0.0.1', port)}"
        for name, datagrams in sockets.items()
        for protocol, port in [(TRACKER_PROTOCOLS[name], datagrams.getsockname()[1])]
    ]
