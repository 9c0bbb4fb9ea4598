"""Announces a show on the network (mDNS), so that control surfaces find it: a process of its own, beside the show.

What may go wrong in it, with the network or with `zeroconf`, costs the announcement alone. It ends when its standard
input does, so nothing outlives the command that started it.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import ipaddress
import socket
import subprocess
import sys
from collections.abc import AsyncIterator, Iterator
from typing import TYPE_CHECKING

from omote.interchange.formats.error_reasons import explain_error

if TYPE_CHECKING:
    from zeroconf import ServiceInfo

PROGRAM = (sys.executable, "-m", "omote.server.devices.announcement")
OSCQUERY = "_oscjson._tcp.local."
OSC = "_osc._udp.local."
STANDARD_INPUT = 0
END_SECONDS = 2.0
"""How long the process may take to take its announcement back."""
LONGEST_NAME = 40
"""Bytes of a show's name in an announcement, which holds 63 with what stands around it."""


@contextlib.contextmanager
def announce_beside(host: str, port: int, osc: int, show: str) -> Iterator[None]:
    """Announces a show in a process of its own while the context is open; where that fails, it says so itself.

    host: where the show listens; port: of its pages; osc: port of OSC; show: its name.
    """
    words = ["--host", host, "--port", str(port), "--osc", str(osc), "--show", show]
    process = subprocess.Popen(
        [*PROGRAM, *words], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, start_new_session=True
    )
    assert process.stdin is not None
    try:
        yield
    finally:
        process.stdin.close()
        try:
            process.wait(END_SECONDS)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def main(arguments: list[str] | None = None) -> int:
    """Announces until standard input ends; returns the exit status."""
    options = _options(arguments)
    try:
        asyncio.run(_announce_until_told(options))
    except ImportError:
        return _say("install omote[discovery], and surfaces find the show by themselves")
    except (OSError, ValueError) as error:
        return _say(f"surfaces do not find the show by themselves ({explain_error(error)}); type its address there")
    except Exception as error:  # of zeroconf: a name that others hold, a network that is gone
        return _say(f"surfaces do not find the show by themselves ({type(error).__name__}); type its address there")
    return 0


async def _announce_until_told(options: argparse.Namespace) -> None:
    ended = asyncio.Event()
    async with announce(options.host, options.port, options.osc, options.show):
        asyncio.get_running_loop().add_reader(STANDARD_INPUT, ended.set)
        await ended.wait()


@contextlib.asynccontextmanager
async def announce(host: str, port: int, osc: int, show: str) -> AsyncIterator[None]:
    """Announces a show's tree of addresses and its OSC while the context is open, on the networks that it is heard on;
    ImportError without `zeroconf`, OSError where there is no multicast.

    host: where the show listens; port: of its pages; osc: port of OSC; show: its name.
    """
    from zeroconf import InterfaceChoice, IPVersion
    from zeroconf.asyncio import AsyncZeroconf

    numeric = str(socket.getaddrinfo(host, None)[0][4][0])
    everywhere = ipaddress.ip_address(numeric).is_unspecified
    version = IPVersion.V6Only if ":" in numeric and not everywhere else IPVersion.V4Only
    interfaces = InterfaceChoice.All if everywhere else [numeric]
    network = AsyncZeroconf(interfaces=interfaces, ip_version=version)
    try:
        addresses = _addresses() if everywhere else [numeric]
        announced = services(addresses, port, osc, show)
        await asyncio.gather(
            *(network.async_register_service(service, allow_name_change=True) for service in announced)
        )
        yield
    finally:
        await network.async_close()


def services(addresses: list[str], port: int, osc: int, show: str) -> list[ServiceInfo]:
    """What is announced: OSCQuery at the port of the pages, and plain OSC.

    addresses: of this machine; port: of the pages; osc: port of OSC; show: its name.
    """
    from zeroconf import ServiceInfo

    name = show.encode()[:LONGEST_NAME].decode(errors="ignore").replace(".", " ").strip()
    server = f"{socket.gethostname().partition('.')[0]}.local."
    return [
        ServiceInfo(
            kind, f"Omote {name}".strip() + f".{kind}", port=number, server=server, parsed_addresses=list(addresses)
        )
        for kind, number in ((OSCQUERY, port), (OSC, osc))
    ]


def _addresses() -> list[str]:
    """This machine's addresses of IPv4, those that others reach before its own."""
    from ifaddr import get_adapters

    addresses = [str(ip.ip) for adapter in get_adapters() for ip in adapter.ips if ip.is_IPv4]
    return [address for address in addresses if not address.startswith("127.")] or addresses


def _say(sentence: str) -> int:
    sys.stderr.write(f"omote: {sentence}.\n")
    return 1


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="omote.server.devices.announcement", description=__doc__)
    parser.add_argument("--host", required=True)
    parser.add_argument("--port", type=int, required=True)
    parser.add_argument("--osc", type=int, required=True)
    parser.add_argument("--show", required=True)
    return parser.parse_args(arguments)


if __name__ == "__main__":
    sys.exit(main())
