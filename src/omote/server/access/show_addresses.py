"""Addresses (URLs) under which browsers reach a show."""

from __future__ import annotations

import ipaddress
import socket
from urllib.parse import urlsplit

from omote.server.access.security import own_names
from omote.show.access.access_role import HIGHEST, AccessRole
from omote.show.access.people_list import People, token_of

ANYWHERE = ("0.0.0.0", "::")
HOME_BITS = 24
"""Bits that addresses of a usual network at home or on a stage share; the route does not tell them."""
FIRST_PAGES: dict[AccessRole, str] = {"view": "/stage", "operate": "/console", "edit": "/editor", "admin": "/console"}
"""The page that somebody of a role opens first."""


def local_address(host: str, port: int, scheme: str = "http") -> str:
    """The URL of a show for a browser on this machine. host, port: where it listens; scheme: http or https."""
    return url("127.0.0.1" if host in ANYWHERE else host, port, scheme)


def reachable_addresses(host: str, port: int, scheme: str = "http") -> list[str]:
    """The URLs of a show: for this machine and, where it listens on all interfaces, for the network.

    host, port: where it listens; scheme: http or https.
    """
    first = local_address(host, port, scheme)
    outside = own_address() if host in ANYWHERE else None
    return [first] if outside is None else [first, url(outside, port, scheme)]


def outside_address(host: str, port: int, scheme: str = "http") -> str:
    """The URL of a show that listens on an address, for other machines; "" where none reaches it.

    host, port: where it listens; scheme: http or https.
    """
    outside = own_address() if host in ANYWHERE else host
    return "" if outside is None or is_loopback(outside) else url(outside, port, scheme)


def entry_address(base: str, role: AccessRole, token: str) -> str:
    """The URL by which somebody enters with a token; where the base is this machine's alone, by its address in the
    network.

    role: whose first page it opens.
    """
    parts = urlsplit(base)
    outside = own_address() if is_loopback(parts.hostname or "") else None
    place = base if outside is None else url(outside, parts.port or 80, parts.scheme)
    return f"{place}{FIRST_PAGES[role]}?token={token}"


def own_entries(base: str, people: People | None) -> list[str]:
    """The URLs of stage and console for whoever has started the show; with the token of an admin, where the show asks
    for one.

    base: the URL without a page; people: who has tokens, None where none are asked for.
    """
    admins = [person for person in people.people if person.role == HIGHEST] if people is not None else []
    query = f"?token={token_of(people, admins[0])}" if people is not None and admins else ""
    return [f"{base}/stage{query}", f"{base}/console{query}"]


def url(host: str, port: int, scheme: str = "http") -> str:
    """The URL of a host and port; IPv6 addresses get brackets. host, port: where it listens; scheme: http or https."""
    return f"{scheme}://[{host}]:{port}" if ":" in host else f"{scheme}://{host}:{port}"


def split_url(address: str) -> tuple[str, str, int]:
    """The scheme, host and port of what `url` gave; http, "" and 0 for anything else."""
    try:
        parts = urlsplit(address)
        host = parts.hostname
        port = parts.port
    except ValueError:
        return "http", "", 0
    return (parts.scheme, host, port) if host and port and parts.scheme in ("http", "https") else ("http", "", 0)


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches what listens on an address."""
    try:
        return host.lower() == "localhost" or ipaddress.ip_address(host.partition("%")[0]).is_loopback
    except ValueError:
        return False


def certificate_names(host: str) -> list[str]:
    """The names and addresses of this machine under which a browser may call a show that listens on a host."""
    names = [*sorted(own_names()), "127.0.0.1", "::1", own_address() or "", "" if host in ANYWHERE else host]
    with_addresses = [*names, *_addresses_of(socket.gethostname())]
    return [name for name in dict.fromkeys(with_addresses) if name]


def own_address() -> str | None:
    """This machine's IP address in its network, None without one; nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address set apart for documentation: only the route is asked for
            address = str(probe.getsockname()[0])
        except OSError:
            return None
    return None if address.startswith(("127.", "0.")) else address


def own_network() -> str:
    """The network that this machine's address is most likely of, as an operator lets it play: 192.168.1.0/24."""
    address = own_address() or "192.168.1.7"
    return str(ipaddress.ip_network(f"{address}/{HOME_BITS}", strict=False))


def _addresses_of(name: str) -> list[str]:
    try:
        records = socket.getaddrinfo(name, None, proto=socket.IPPROTO_TCP)
    except OSError:
        return []
    return [str(address[0]).partition("%")[0] for *_, address in records]
