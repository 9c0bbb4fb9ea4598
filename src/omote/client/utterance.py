"""What a program said, to wait until it is over."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator
from typing import Generic, TypeVar

from omote.perform.limits import check_within
from omote.perform.scene.character_names import ALL
from omote.show.objects.speech import Say
from omote.show.objects.state import State


class SpeechWatch:
    """Follows one speech of a character, or one of all (`*`), by its key.

    Any state may be lost between two: what waited behind a speech and was said to its end since says that the speech
    itself was, for an interruption ends all that waits.
    """

    def __init__(self, key: str, character: str, state: State, sound: str = "") -> None:
        self.key = key
        self.sound = sound
        self._left = dict.fromkeys(state.characters if character == ALL else [character], frozenset({key}))
        self._spoken = True
        self.note(state)

    @property
    def spoken(self) -> bool | None:
        """True once it was said to its end, by all who say it; False once it is over otherwise; None before."""
        return None if self._left else self._spoken

    def note(self, state: State) -> None:
        """Follows a newer state; who is no longer in it says nothing any more."""
        for name, known in list(self._left.items()):
            character = state.characters.get(name)
            keys = [] if character is None or character.speech is None else character.speech.keys
            if self.key in keys:
                self._left[name] = known | frozenset(keys[keys.index(self.key) :])
                continue
            self._spoken &= character is not None and character.spoken in known
            del self._left[name]


class SpeechWatches:
    """All that a program has said and that is not over."""

    def __init__(self) -> None:
        self._watches: list[SpeechWatch] = []

    def add(self, said: Say, state: State) -> SpeechWatch:
        """Follows what was said from now on. state: the first that knows of it."""
        watch = SpeechWatch(said.key, said.character, state, said.sound)
        self._watches.append(watch)
        return watch

    def note(self, state: State) -> None:
        """Follows a newer state."""
        for watch in self._watches:
            watch.note(state)
        self._watches = [watch for watch in self._watches if watch.spoken is None]

    def sounds(self) -> Iterator[str]:
        """The keys of the sounds that are needed, the first first."""
        return (watch.sound for watch in self._watches if watch.sound)


LONGEST_WAIT = 86400.0
"""Seconds: a day."""


Waited = TypeVar("Waited")


class _Spoken(Generic[Waited]):
    """One speech. wait: waits until it is over, for so many seconds."""

    def __init__(self, watch: SpeechWatch, wait: Callable[[SpeechWatch, float | None], Waited]) -> None:
        self._watch = watch
        self._wait = wait

    @property
    def spoken(self) -> bool | None:
        """None while it is said or waits for its turn, True once it was said to its end, False once it was interrupted:
        by another `say`, `stop_speaking`, a panic, or because its character is gone."""
        return self._watch.spoken

    def __repr__(self) -> str:
        """How it stands."""
        return f"<utterance that {explain_end(self.spoken)}>"


class Utterance(_Spoken[bool]):
    """One speech, as `say` gives it; it needs not be waited for."""

    def wait(self, timeout: float | None = None) -> bool:
        """Waits until it is over, at most `timeout` seconds (None: as long as it takes), and returns whether it was
        said to its end. TimeoutError where it goes on; ConnectionError where the show does not come back."""
        return self._wait(self._watch, _check_timeout(timeout))


class AsyncUtterance(_Spoken[Awaitable[bool]]):
    """One speech, as `await say(...)` gives it; it needs not be waited for."""

    async def wait(self, timeout: float | None = None) -> bool:
        """Waits until it is over, at most `timeout` seconds (None: as long as it takes), and returns whether it was
        said to its end. TimeoutError where it goes on; ConnectionError where the show does not come back."""
        return await self._wait(self._watch, _check_timeout(timeout))


def explain_end(spoken: bool | None) -> str:
    """How a speech stands, in words."""
    return "is not over" if spoken is None else "was said to its end" if spoken else "was interrupted"


def _check_timeout(timeout: float | None) -> float | None:
    return None if timeout is None else check_within(timeout, 0.0, LONGEST_WAIT, "the time to wait (seconds)")
