"""Addresses (URLs) under which browsers reach a show."""

from __future__ import annotations

import socket

ANYWHERE = ("0.0.0.0", "::")


def local_address(host: str, port: int) -> str:
    """The URL of a show for a browser on this machine."""
    return url("127.0.0.1" if host in ANYWHERE else host, port)


def reachable_addresses(host: str, port: int) -> list[str]:
    """The URLs of a show: for this machine and, where it listens on all interfaces, for the network."""
    first = local_address(host, port)
    outside = own_address() if host in ANYWHERE else None
    return [first] if outside is None else [first, url(outside, port)]


def url(host: str, port: int) -> str:
    """The http URL of a host and port; IPv6 addresses get brackets."""
    return f"http://[{host}]:{port}" if ":" in host else f"http://{host}:{port}"


def own_address() -> str | None:
    """This machine's IP address in its network, None without one; nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address set apart for documentation: only the route is asked for
            address = str(probe.getsockname()[0])
        except OSError:
            return None
    return None if address.startswith(("127.", "0.")) else address
