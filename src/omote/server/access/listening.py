"""A socket for pages that only this machine opens."""

from __future__ import annotations

import errno
import socket

from omote.interchange.formats.error_reasons import explain_error

LOCALHOST = "127.0.0.1"


def listen(port: int) -> socket.socket:
    """A socket for this machine alone; OSError with a message where the port cannot be had. port: 0 for any."""
    opened = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    try:
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        opened.bind((LOCALHOST, port))
    except OSError as error:
        opened.close()
        taken = "another program has it" if error.errno == errno.EADDRINUSE else explain_error(error)
        raise OSError(f"port {port} cannot be opened ({taken}): name another, --port {port + 1}") from error
    return opened
