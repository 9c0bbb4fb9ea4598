"""Sockets of devices, and what is handed to a standby."""

import argparse
import socket

import pytest

from omote.inputs.dmx.sacn_packet import HIGHEST_UNIVERSE
from omote.server.access.show_addresses import own_address
from omote.server.devices.trackers.tracker_sockets import listen_for_trackers, read_trackers
from omote.server.supervision.device_sockets import (
    MOST_UNIVERSES,
    DeviceOptions,
    DeviceSockets,
    add_device_options,
    listen_for_artnet,
    listen_for_sacn,
    read_device_options,
    read_universes,
)
from omote.server.supervision.listening_socket import listen_for_osc

HOST = "127.0.0.1"


def parse(words: list[str]) -> DeviceOptions:
    parser = argparse.ArgumentParser()
    add_device_options(parser)
    return read_device_options(parser.parse_args(words))


def test_a_standby_reads_what_the_operator_asked_for() -> None:
    options = DeviceOptions(
        universes=(1, 7),
        allow="10.0.0.0/8,any",
        bindings="a b.toml",
        listen="vmc:0",
        send="osc:10.0.0.5:9001",
        show_control=5,
        recorded=False,
    )
    assert parse(options.words) == options
    assert parse([]) == DeviceOptions()


def test_each_socket_is_handed_under_its_option_and_closed() -> None:
    trackers = listen_for_trackers(read_trackers("vmc-performer:0"), list[str]().append)
    sockets = DeviceSockets(
        listen_for_osc(HOST, 0), listen_for_sacn(HOST, [1, 2], port=0), listen_for_artnet(HOST, 0), trackers
    )
    try:
        check_handed(sockets)
    finally:
        sockets.close()
    assert sockets.trackers["vmc-performer"].fileno() == -1
    assert sockets.sacn is not None
    assert sockets.sacn.fileno() == -1
    assert DeviceSockets().handed == {}
    assert DeviceSockets().heard == []


def check_handed(sockets: DeviceSockets) -> None:
    words = [word for name, number in sockets.handed.items() for word in (name, str(number))]
    options = parse(words)
    assert sockets.osc is not None
    assert sockets.sacn is not None
    assert sockets.artnet is not None
    assert options.osc == sockets.osc.datagrams.fileno()
    assert (options.sacn, options.artnet) == (sockets.sacn.fileno(), sockets.artnet.fileno())
    assert options.trackers == {"vmc-performer": sockets.trackers["vmc-performer"].fileno()}
    assert sockets.heard == ["OSC", "sACN", "Art-Net", "VMC performer"]
    assert sockets.advice[0].startswith("tracker  VMC performer: port")


@pytest.mark.parametrize(
    ("text", "universes"), [("off", ()), ("1", (1,)), ("1,3-5", (1, 3, 4, 5)), (" 2 , 2", (2,)), ("63999", (63999,))]
)
def test_universes_are_read_as_they_are_typed(text: str, universes: tuple[int, ...]) -> None:
    assert read_universes(text) == universes


@pytest.mark.parametrize(
    "text", ["", "0", str(HIGHEST_UNIVERSE + 1), "a", "1-", "-1", "3-1", f"1-{MOST_UNIVERSES + 1}", "1-63999", "1,,2"]
)
def test_what_is_no_list_of_universes_is_said(text: str) -> None:
    with pytest.raises(ValueError, match="universe"):
        read_universes(text)


@pytest.mark.parametrize("card", [HOST, own_address() or HOST])
def test_a_packet_to_a_universe_s_group_arrives_from_a_desk_on_this_machine(card: str) -> None:
    with listen_for_sacn(HOST, [300], port=0) as ours, socket.socket(type=socket.SOCK_DGRAM) as desk:
        desk.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton(card))
        desk.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        desk.sendto(b"hello", ("239.255.1.44", ours.getsockname()[1]))
        ours.settimeout(60.0)
        assert ours.recv(10) == b"hello"


def test_what_cannot_be_opened_is_said() -> None:
    with pytest.raises(OSError, match=r"Art-Net is heard over IPv4 alone"):
        listen_for_artnet("::1")
    with pytest.raises(OSError, match=r"groups of sACN cannot be joined"):
        listen_for_sacn("203.0.113.9", [1], port=0)
    with socket.socket(type=socket.SOCK_DGRAM) as taken:
        taken.bind(("", 0))
        with pytest.raises(OSError, match=r"port \d+ cannot be opened for Art-Net \(it is in use"):
            listen_for_artnet(HOST, taken.getsockname()[1])
