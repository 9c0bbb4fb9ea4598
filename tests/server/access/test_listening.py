"""A socket for this machine alone, or why there is none."""

import socket

import pytest

from omote.server.access.listening import listen


def test_a_port_that_is_taken_is_said() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with pytest.raises(OSError, match=f"port {port} cannot be opened .another program has it.* --port {port + 1}"):
            listen(port)
