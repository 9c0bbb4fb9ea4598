"""Limits how many wrong tokens one sender may try; times are passed in."""

from __future__ import annotations

import hashlib
import ipaddress
from collections import OrderedDict
from dataclasses import dataclass, field

from omote.show.rate_limit import TokenBucket

TRIES_PER_SECOND, TRIES_AT_ONCE = 0.2, 10.0
MOST_SENDERS = 1024
"""Senders that are remembered; a flood of them forgets the oldest."""


@dataclass(eq=False)
class _Tries:
    bucket: TokenBucket = field(default_factory=lambda: TokenBucket(TRIES_PER_SECOND, TRIES_AT_ONCE))
    last: bytes = b""
    blocked: bool = False


class WrongTokens:
    """The senders of wrong tokens. One that sends the same again, as an open page does, guesses nothing."""

    def __init__(self) -> None:
        self._senders: OrderedDict[str, _Tries] = OrderedDict()

    def note(self, host: str, token: str, now: float) -> None:
        """Notes a wrong token of a host."""
        tries = self._senders.setdefault(_sender(host), _Tries())
        self._senders.move_to_end(_sender(host))
        if len(self._senders) > MOST_SENDERS:
            self._senders.popitem(last=False)
        digest = hashlib.sha256(token.encode(errors="replace")).digest()
        if digest != tries.last:
            tries.last, tries.blocked = digest, not tries.bucket.take(now)

    def is_blocked(self, host: str, now: float) -> bool:
        """Whether a host has guessed too often to be heard now."""
        tries = self._senders.get(_sender(host))
        if tries is None or not tries.blocked:
            return False
        tries.blocked = not tries.bucket.take(now)
        return tries.blocked


def _sender(host: str) -> str:
    """The host, or the network of an IPv6 host, which has as many addresses there as it likes."""
    try:
        address = ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return host
    return host if address.version == 4 else str(ipaddress.ip_network((address, 64), strict=False))
