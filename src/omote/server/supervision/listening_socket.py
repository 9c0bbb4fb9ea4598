"""Opens the listening sockets of a show, or says in plain words why it cannot be."""

from __future__ import annotations

import contextlib
import errno
import socket

from omote.interchange.formats.error_reasons import explain_error
from omote.server.devices.osc_listener import OscSockets

FREE_PORT_TRIES = 20
"""A number that the system gives as free for datagrams may be taken for connections."""
LOWEST_FREE_PORT = 1024
"""Ports below it want rights that a show has no need of."""
HOSTS = "give --host 127.0.0.1 for this machine alone, 0.0.0.0 for the whole network"


def listen_on(host: str, port: int) -> socket.socket:
    """Opens the listening socket of a show; OSError with a message when the port is taken or the address is not
    ours.

    host: the address; port: 0 for any.
    """
    if not host:
        raise OSError(f"--host is empty: {HOSTS}.")
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    try:
        return socket.create_server((host, port), family=family, backlog=512)
    except UnicodeError as error:
        raise OSError(f"{host} is no address of this machine: {HOSTS}.") from error
    except OSError as error:
        raise OSError(_refused_address(host, port, error)) from error


def listen_for_osc(host: str, port: int) -> OscSockets:
    """Opens the sockets of OSC: UDP and TCP under one number (0: any that is free in both); OSError with a message
    where UDP cannot be had.

    Where another program has that port of TCP, OSC is heard over UDP alone. host: the address; port: of both.
    """
    sockets = _listen_for_osc(host, port)
    for _ in range(FREE_PORT_TRIES if port == 0 else 0):
        if sockets.connections is not None:
            break
        sockets.close()
        sockets = _listen_for_osc(host, port)
    return sockets


def _listen_for_osc(host: str, port: int) -> OscSockets:
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    datagrams = socket.socket(family, socket.SOCK_DGRAM)
    try:
        datagrams.bind((host, port))
    except OSError as error:
        datagrams.close()
        reason = "another program has it, perhaps another show" if error.errno == errno.EADDRINUSE else None
        raise OSError(
            f"port {port} on {host} cannot be opened for OSC ({reason or explain_error(error)}): "
            "name another with --osc, or --osc off."
        ) from error
    with contextlib.suppress(OSError):
        number = datagrams.getsockname()[1]
        return OscSockets(datagrams, socket.create_server((host, number), family=family))
    return OscSockets(datagrams, None)


def _refused_address(host: str, port: int, error: OSError) -> str:
    """Why a show cannot listen there, and what to do, as a whole sentence."""
    if (error.errno or 0) <= 0:  # the numbers of a look-up that failed are negative
        return f"no address of the name {host} is known: {HOSTS}."
    if error.errno == errno.EADDRNOTAVAIL:
        return f"{host} is no address of this machine: {HOSTS}."
    place = f"port {port} on {host} cannot be opened"
    advice = "name another with --port, 0 for any free one"
    if error.errno == errno.EADDRINUSE:
        return f"{place} (it is in use by another program, perhaps another show): end that, or {advice}."
    if error.errno in (errno.EACCES, errno.EPERM) and port < LOWEST_FREE_PORT:
        return f"{place} (ports below {LOWEST_FREE_PORT} belong to the administrator): {advice}."
    return f"{place} ({explain_error(error)}): {advice}."
