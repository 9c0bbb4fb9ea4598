"""Who may play the show by packets: this machine, and the networks that the operator names."""

from __future__ import annotations

import ipaddress
from collections import OrderedDict
from dataclasses import dataclass, field

Network = ipaddress.IPv4Network | ipaddress.IPv6Network
ANYBODY = "any"
MOST_REMEMBERED = 256
"""Hosts whose verdict is remembered: a flood comes from few."""


@dataclass(frozen=True)
class AllowedSenders:
    """The networks that are heard beside this machine."""

    networks: tuple[Network, ...] = ()
    _verdicts: OrderedDict[str, bool] = field(default_factory=OrderedDict, repr=False, compare=False)

    def allows(self, host: str) -> bool:
        """Whether a packet from a host is heard; host: as a socket tells it."""
        if host not in self._verdicts:
            self._verdicts[host] = self._judge(host)
            if len(self._verdicts) > MOST_REMEMBERED:
                self._verdicts.popitem(last=False)
        return self._verdicts[host]

    def with_host(self, host: str | None) -> AllowedSenders:
        """These, and a host; None adds nobody."""
        return self if host is None else AllowedSenders((*self.networks, _read_network(host)))

    def _judge(self, host: str) -> bool:
        try:
            address = ipaddress.ip_address(host.partition("%")[0])
        except ValueError:
            return False
        mapped = address.ipv4_mapped if isinstance(address, ipaddress.IPv6Address) else None
        address = mapped or address
        return address.is_loopback or any(address in network for network in self.networks)


THIS_MACHINE = AllowedSenders()


def read_senders(text: str) -> AllowedSenders:
    """The senders of a list as it is typed: addresses and networks by commas, or `any`; else ValueError."""
    words = [word.strip() for word in text.split(",") if word.strip()]
    if not words:
        raise ValueError("no sender is named; give addresses or networks, such as 192.168.1.0/24, or any")
    if [word.lower() for word in words] == [ANYBODY]:
        return AllowedSenders((ipaddress.ip_network("0.0.0.0/0"), ipaddress.ip_network("::/0")))
    return AllowedSenders(tuple(map(_read_network, words)))


def _read_network(word: str) -> Network:
    try:
        return ipaddress.ip_network(word)
    except ValueError as error:
        why = "has bits behind its length" if "host bits" in str(error) else "is neither an address nor a network"
        raise ValueError(f"{word[:60]!r} {why}; give such as 192.168.1.7 or 192.168.1.0/24") from error
