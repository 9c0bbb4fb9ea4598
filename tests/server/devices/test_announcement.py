"""The announcement on the loopback network, found by zeroconf's own browser."""

import socket
import subprocess
import sys

import pytest
from zeroconf import IPVersion, ServiceBrowser, ServiceListener, Zeroconf

from omote.server.devices import announcement
from omote.server.devices.announcement import LONGEST_NAME, OSC, OSCQUERY, announce_beside, main, services

HOST = "127.0.0.1"
FOUND_MILLISECONDS = 60_000


class Found(ServiceListener):
    """Notes what comes; what goes and changes is of no interest."""

    def __init__(self) -> None:
        self.names: set[str] = set()

    def add_service(self, zc: Zeroconf, type_: str, name: str) -> None:  # noqa: ARG002
        self.names.add(name)

    def remove_service(self, zc: Zeroconf, type_: str, name: str) -> None: ...

    def update_service(self, zc: Zeroconf, type_: str, name: str) -> None: ...


def test_a_surface_finds_the_show_and_both_its_ports() -> None:
    with announce_beside(HOST, 8123, 9123, "ghosts.v2"):
        network = Zeroconf(interfaces=[HOST], ip_version=IPVersion.V4Only)
        try:
            found = Found()
            browser = ServiceBrowser(network, [OSCQUERY, OSC], found)
            for kind, port in ((OSCQUERY, 8123), (OSC, 9123)):
                info = network.get_service_info(kind, f"Omote ghosts v2.{kind}", timeout=FOUND_MILLISECONDS)
                assert info is not None
                assert (info.port, info.parsed_addresses()) == (port, [HOST])
            browser.cancel()
        finally:
            network.close()


def test_names_of_shows_fit_into_an_announcement() -> None:
    for name in ("x" * 200, "能面" * 60, "a.b", ""):
        for service in services([HOST], 1, 2, name):
            label = service.name.removesuffix(f".{service.type}")
            assert len(label.encode()) <= LONGEST_NAME + len("Omote ")
            assert "." not in label


def test_without_zeroconf_it_is_said_and_nothing_fails(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "zeroconf", None)
    assert main(["--host", HOST, "--port", "1", "--osc", "2", "--show", "a"]) == 1
    assert capsys.readouterr().err == "omote: install omote[discovery], and surfaces find the show by themselves.\n"


@pytest.mark.parametrize("error", [OSError(101, "Network is unreachable"), RuntimeError("no")])
def test_a_network_without_multicast_is_said(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], error: Exception
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr("zeroconf.asyncio.AsyncZeroconf", fail)
    assert main(["--host", HOST, "--port", "1", "--osc", "2", "--show", "a"]) == 1
    assert "surfaces do not find the show by themselves" in capsys.readouterr().err


def test_it_ends_with_what_started_it() -> None:
    words = ["--host", HOST, "--port", "1", "--osc", "2", "--show", "a"]
    process = subprocess.Popen([*announcement.PROGRAM, *words], stdin=subprocess.PIPE)
    process.communicate()
    assert process.returncode == 0


def test_a_host_that_is_none_is_said(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def unknown(*_: object) -> None:
        raise socket.gaierror(-2, "Name or service not known")

    monkeypatch.setattr(socket, "getaddrinfo", unknown)
    assert main(["--host", "nowhere", "--port", "1", "--osc", "2", "--show", "a"]) == 1
    assert "type its address there" in capsys.readouterr().err
