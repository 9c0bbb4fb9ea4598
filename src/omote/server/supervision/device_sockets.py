"""Opens the sockets of what plays a show beside its pages, and hands them to standby and servers by descriptor."""

from __future__ import annotations

import argparse
import socket
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from omote.inputs.dmx.artnet_packet import ARTNET_PORT
from omote.inputs.dmx.sacn_packet import HIGHEST_UNIVERSE, LOWEST_UNIVERSE, SACN_PORT
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.interchange.formats.error_reasons import explain_error
from omote.server.access.show_addresses import ANYWHERE, is_loopback, own_address
from omote.server.devices.osc_listener import OscSockets
from omote.server.devices.trackers.tracker_sockets import OPTION, explain_trackers

MOST_UNIVERSES = 16
"""Universes of sACN: Linux joins twenty groups with one socket."""
LOOPBACK = "127.0.0.1"


@dataclass(frozen=True)
class DeviceSockets:
    """The sockets of a show's devices; None for what is not heard."""

    osc: OscSockets | None = None
    sacn: socket.socket | None = None
    artnet: socket.socket | None = None
    trackers: Mapping[str, socket.socket] = field(default_factory=dict)

    @property
    def handed(self) -> dict[str, int]:
        """Their descriptors, by the option of a standby that takes each."""
        single = {"--sacn": self.sacn, "--artnet": self.artnet}
        lighting = {name: datagrams.fileno() for name, datagrams in single.items() if datagrams is not None}
        trackers = {OPTION + name: datagrams.fileno() for name, datagrams in self.trackers.items()}
        return {**({} if self.osc is None else self.osc.handed), **lighting, **trackers}

    @property
    def heard(self) -> list[str]:
        """What is heard, in words."""
        named = {"OSC": self.osc, "sACN": self.sacn, "Art-Net": self.artnet}
        trackers = [TRACKER_PROTOCOLS[name].title for name in self.trackers]
        return [name for name, opened in named.items() if opened is not None] + trackers

    @property
    def advice(self) -> list[str]:
        """What to do at the sender of each tracker, in words."""
        return explain_trackers(self.trackers)

    def close(self) -> None:
        """Closes all of them."""
        for opened in (self.osc, self.sacn, self.artnet, *self.trackers.values()):
            if opened is not None:
                opened.close()


@dataclass(frozen=True)
class DeviceOptions:
    """What a server is told of devices: descriptors of sockets, and what the operator asked for, as it was typed.

    trackers: descriptors by the names of their protocols; listen: what was asked for of them; send: where faces
    are sent; show_control: the device that the show is for MIDI Show Control; recorded: whether the show is recorded.
    """

    osc: int | None = None
    osc_connections: int | None = None
    sacn: int | None = None
    artnet: int | None = None
    universes: Sequence[int] = field(default=())
    allow: str = ""
    bindings: str = ""
    trackers: Mapping[str, int] = field(default_factory=dict)
    listen: str = ""
    send: str = ""
    show_control: int = 0
    recorded: bool = True

    @property
    def words(self) -> list[str]:
        """The words of a standby's command line that say the same, but for descriptors."""
        universes = [word for number in self.universes for word in ("--universe", str(number))]
        named = {"--allow": self.allow, "--bindings": self.bindings, "--trackers": self.listen, "--send": self.send}
        named |= {"--show-control": str(self.show_control)} if self.show_control else {}
        switches = [] if self.recorded else ["--no-record"]
        return universes + switches + [word for name, value in named.items() if value for word in (name, value)]


NO_DEVICES = DeviceOptions()


def add_device_options(parser: argparse.ArgumentParser) -> None:
    """Adds what `read_device_options` reads."""
    for name in ("--osc", "--osc-connections", "--sacn", "--artnet"):
        parser.add_argument(name, type=int, default=None)
    parser.add_argument("--universe", type=int, action="append", default=[])
    for name in TRACKER_PROTOCOLS:
        parser.add_argument(OPTION + name, type=int, default=None)
    for name in ("--allow", "--bindings", "--trackers", "--send"):
        parser.add_argument(name, default="")
    parser.add_argument("--show-control", type=int, default=0)
    parser.add_argument("--no-record", dest="recorded", action="store_false")


def read_device_options(options: argparse.Namespace) -> DeviceOptions:
    """What a standby was told of devices."""
    descriptors = (options.osc, options.osc_connections, options.sacn, options.artnet)
    handed = {name: getattr(options, f"{OPTION}{name}".strip("-").replace("-", "_")) for name in TRACKER_PROTOCOLS}
    trackers = {name: descriptor for name, descriptor in handed.items() if descriptor is not None}
    typed = {"allow": options.allow, "bindings": options.bindings, "listen": options.trackers, "send": options.send}
    universes = tuple(options.universe)
    return DeviceOptions(
        *descriptors,
        universes,
        trackers=trackers,
        show_control=options.show_control,
        recorded=options.recorded,
        **typed,
    )


def read_universes(text: str) -> tuple[int, ...]:
    """The universes of a list as it is typed, `1,3-5`; none for "off"; ValueError with what is wrong."""
    universes: dict[int, None] = {}
    for word in text.split(",") if text.strip().lower() != "off" else ():
        first, dash, last = word.strip().partition("-")
        low = _universe(first, word)
        high = _universe(last if dash else first, word)
        universes |= dict.fromkeys(range(low, min(high, low + MOST_UNIVERSES) + 1))
        if low > high or len(universes) > MOST_UNIVERSES:
            raise ValueError(f"{text[:60]!r} is no list of at most {MOST_UNIVERSES} universes, such as 1,3-5")
    return tuple(universes)


def _universe(text: str, word: str) -> int:
    digits = text.strip()
    if not (digits.isascii() and digits.isdecimal() and LOWEST_UNIVERSE <= int(digits[:9]) <= HIGHEST_UNIVERSE):
        raise ValueError(f"{word[:60]!r} is no universe; give {LOWEST_UNIVERSE} to {HIGHEST_UNIVERSE}, such as 1,3-5")
    return int(digits)


def listen_for_sacn(host: str, universes: Sequence[int], port: int = SACN_PORT) -> socket.socket:
    """A socket that hears sACN, unicast and in the groups of these universes on the networks of the show's host, of a
    show of this machine alone too where its desk may be: OLA sends by a network card, never on loopback; OSError with
    a message.

    host: of the show; universes: their numbers; port: UDP.
    """
    datagrams = _listen(host, port, "sACN")
    address = LOOPBACK if host in ANYWHERE else socket.gethostbyname(host)
    interfaces = {address: None, own_address() if is_loopback(address) else None: None}
    try:
        for universe in universes:
            group = socket.inet_aton(f"239.255.{universe >> 8}.{universe & 0xFF}")
            for interface in filter(None, interfaces):
                membership = group + socket.inet_aton(interface)
                datagrams.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
    except OSError as error:
        datagrams.close()
        raise OSError(
            f"the groups of sACN cannot be joined ({explain_error(error)}): see --host and --sacn."
        ) from error
    return datagrams


def listen_for_artnet(host: str, port: int = ARTNET_PORT) -> socket.socket:
    """A socket that hears Art-Net, broadcast too; OSError with a message. host: of the show; port: UDP."""
    return _listen(host, port, "Art-Net")


def _listen(host: str, port: int, what: str) -> socket.socket:
    """A socket for datagrams to groups and to all, which none bound to one address gets; who is heard, the list of
    allowed senders decides."""
    if ":" in host:
        raise OSError(f"{what} is heard over IPv4 alone: give --host an address of IPv4.")
    datagrams = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    datagrams.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # a desk on this machine has the same port
    try:
        datagrams.bind(("", port))
    except OSError as error:
        datagrams.close()
        raise OSError(f"port {port} cannot be opened for {what} ({explain_error(error)}).") from error
    return datagrams
