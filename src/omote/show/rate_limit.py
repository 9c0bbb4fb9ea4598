"""Limits the rate of a client's messages (token bucket)."""

from __future__ import annotations


class TokenBucket:
    """Lets `burst` messages pass at once and `rate` per second after that; time is passed in."""

    def __init__(self, rate: float, burst: float) -> None:
        self.rate = rate
        self._burst = burst
        self._tokens = burst
        self._then = 0.0

    def take(self, now: float) -> bool:
        """Whether one more message may pass at `now` (seconds, monotonic)."""
        self._tokens = min(self._burst, self._tokens + max(0.0, now - self._then) * self.rate)
        self._then = now
        if self._tokens < 1.0:
            return False
        self._tokens -= 1.0
        return True
