"""The listening socket of a show, and why it cannot be opened, in plain words."""

import errno
import socket

import pytest

from omote.server.supervision.listening_socket import listen_for_osc, listen_on


def test_a_port_in_use_is_said_in_a_sentence() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        words = rf"port {port} on 127\.0\.0\.1 cannot be opened \(.*in use by another program.*\): .*--port, 0 for any"
        with pytest.raises(OSError, match=words):
            listen_on("127.0.0.1", port)


def test_any_free_port_is_found() -> None:
    with listen_on("127.0.0.1", 0) as listening:
        assert listening.getsockname()[1] > 0


def test_no_host_is_not_every_host() -> None:
    with pytest.raises(OSError, match=r"--host is empty: .*0\.0\.0\.0 for the whole network"):
        listen_on("", 0)


@pytest.mark.parametrize("host", ["nowhere.invalid", "a..b", "x" * 80, "192.0.2.1"])
def test_a_host_that_is_none_is_said_in_a_sentence(host: str) -> None:
    with pytest.raises(OSError, match=r"(is no address of this machine|is known): give --host 127.*network\.$") as said:
        listen_on(host, 0)
    assert "Errno" not in str(said.value)


@pytest.mark.parametrize(
    ("number", "port", "words"),
    [
        (errno.EACCES, 80, "ports below 1024 belong to the administrator"),
        (errno.EACCES, 8090, "you are not allowed to"),
        (errno.EMFILE, 8090, "too many files are open"),
    ],
)
def test_missing_rights_are_said_in_a_sentence(
    monkeypatch: pytest.MonkeyPatch, number: int, port: int, words: str
) -> None:
    def refuse(*_: object, **__: object) -> socket.socket:
        raise OSError(number, "the system's own text")

    monkeypatch.setattr(socket, "create_server", refuse)
    with pytest.raises(OSError, match=rf"port {port} on 127\.0\.0\.1 cannot be opened \({words}\): name another"):
        listen_on("127.0.0.1", port)


def test_a_free_port_for_osc_is_free_for_datagrams_and_for_connections(monkeypatch: pytest.MonkeyPatch) -> None:
    taken: list[int] = []
    create_server = socket.create_server

    def refuse_twice(address: tuple[str, int], *, family: int) -> socket.socket:
        if len(taken) < 2:
            taken.append(address[1])
            raise OSError(errno.EADDRINUSE, "taken")
        return create_server(address, family=family)

    monkeypatch.setattr(socket, "create_server", refuse_twice)
    sockets = listen_for_osc("127.0.0.1", 0)
    try:
        assert sockets.connections is not None
        assert sockets.connections.getsockname() == sockets.datagrams.getsockname()
    finally:
        sockets.close()


def test_osc_is_heard_over_datagrams_alone_where_its_port_is_taken_for_connections() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        sockets = listen_for_osc("127.0.0.1", taken.getsockname()[1])
        assert sockets.connections is None
        sockets.close()
