"""Answers wrong tokens of one sender ever more slowly; a right one never waits. Times are passed in."""

from __future__ import annotations

import hashlib
import ipaddress
from collections import OrderedDict
from dataclasses import dataclass

FREE_TRIES = 10
"""Wrong tokens of a sender that are answered at once: whole schools and museums share one address."""
FORGIVEN_PER_SECOND = 0.2
LONGEST_WAIT = 60.0
"""Seconds; the first wait is one, each further wrong token doubles it."""
MOST_TRIES = FREE_TRIES + 7.0
"""Wrong tokens that are counted: who has waited the longest is forgiven in little more than a minute."""
MOST_SENDERS = 1024
"""Senders that are remembered; a flood of them forgets the oldest."""


@dataclass(eq=False)
class _Tries:
    count: float = 0.0
    then: float = 0.0
    until: float = 0.0
    last: bytes = b""


class WrongTokens:
    """The senders of wrong tokens. One that sends the same again, as an open page does, guesses nothing.

    A token has 132 random bits, so that nobody finds one by trying: the wait keeps logs and answers few, and is for
    whoever sends wrong ones alone.
    """

    def __init__(self) -> None:
        self._senders: OrderedDict[str, _Tries] = OrderedDict()

    def note(self, host: str, token: str, now: float) -> float:
        """Notes a wrong token of a host; returns for how many seconds wrong tokens from there are told nothing more.
        now: seconds."""
        tries = self._senders.setdefault(_sender(host), _Tries())
        self._senders.move_to_end(_sender(host))
        if len(self._senders) > MOST_SENDERS:
            self._senders.popitem(last=False)
        digest = hashlib.sha256(token.encode(errors="replace")).digest()
        if digest != tries.last:
            tries.last = digest
            _count(tries, now)
        return max(0.0, tries.until - now)


def _count(tries: _Tries, now: float) -> None:
    forgiven = FORGIVEN_PER_SECOND * max(0.0, now - tries.then)
    tries.count = min(MOST_TRIES, max(0.0, tries.count - forgiven) + 1.0)
    tries.then = now
    beyond = tries.count - FREE_TRIES
    if beyond > 0.0:
        tries.until = max(tries.until, now + min(LONGEST_WAIT, 2.0 ** (beyond - 1.0)))


def _sender(host: str) -> str:
    """The host, or the network of an IPv6 host, which has as many addresses there as it likes."""
    try:
        address = ipaddress.ip_address(host.partition("%")[0])
    except ValueError:
        return host
    return host if address.version == 4 else str(ipaddress.ip_network((address, 64), strict=False))
