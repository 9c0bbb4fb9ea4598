"""What a program said, to wait until it is over."""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from omote.perform.limits import check_within
from omote.server.client.link.speech_watch import SpeechWatch

LONGEST_WAIT = 86400.0


class Utterance:
    """One speech, as `say` gives it; it needs not be waited for."""

    def __init__(self, watch: SpeechWatch, wait: Callable[[SpeechWatch, float | None], bool]) -> None:
        self._watch, self._wait = watch, wait

    @property
    def spoken(self) -> bool | None:
        """None while it is said or waits for its turn, True once it was said to its end, False once it was interrupted:
        by another `say`, `stop_speaking`, a panic, or because its character is gone."""
        return self._watch.spoken

    def wait(self, timeout: float | None = None) -> bool:
        """Waits until it is over, at most `timeout` seconds (None: as long as it takes), and returns whether it was
        said to its end. TimeoutError where it goes on; ConnectionError where the show does not come back."""
        return self._wait(self._watch, _check_timeout(timeout))

    def __repr__(self) -> str:
        """How it stands."""
        return f"<utterance that {explain_end(self.spoken)}>"


class AsyncUtterance:
    """One speech, as `await say(...)` gives it; it needs not be waited for."""

    def __init__(self, watch: SpeechWatch, wait: Callable[[SpeechWatch, float | None], Awaitable[bool]]) -> None:
        self._watch, self._wait = watch, wait

    @property
    def spoken(self) -> bool | None:
        """None while it is said or waits for its turn, True once it was said to its end, False once it was interrupted:
        by another `say`, `stop_speaking`, a panic, or because its character is gone."""
        return self._watch.spoken

    async def wait(self, timeout: float | None = None) -> bool:
        """Waits until it is over, at most `timeout` seconds (None: as long as it takes), and returns whether it was
        said to its end. TimeoutError where it goes on; ConnectionError where the show does not come back."""
        return await self._wait(self._watch, _check_timeout(timeout))

    def __repr__(self) -> str:
        """How it stands."""
        return f"<utterance that {explain_end(self.spoken)}>"


def explain_end(spoken: bool | None) -> str:
    """How a speech stands, in words."""
    return "is not over" if spoken is None else "was said to its end" if spoken else "was interrupted"


def _check_timeout(timeout: float | None) -> float | None:
    return None if timeout is None else check_within(timeout, 0.0, LONGEST_WAIT, "the time to wait (seconds)")
