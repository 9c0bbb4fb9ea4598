"""Whether what a program said is over, from one state of the show to the next."""

from __future__ import annotations

from collections.abc import Iterator

from omote.perform.scene.character_names import ALL
from omote.show import messages as wire


class SpeechWatch:
    """Follows one speech of a character, or one of all (`*`), by its key.

    Any state may be lost between two: what waited behind a speech and was said to its end since says that the speech
    itself was, for an interruption ends all that waits.
    """

    def __init__(self, key: str, character: str, state: wire.State, sound: str = "") -> None:
        self.key, self.sound = key, sound
        self._left = dict.fromkeys(state.characters if character == ALL else [character], frozenset({key}))
        self._spoken = True
        self.note(state)

    @property
    def spoken(self) -> bool | None:
        """True once it was said to its end, by all who say it; False once it is over otherwise; None before."""
        return None if self._left else self._spoken

    def note(self, state: wire.State) -> None:
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

    def add(self, said: wire.Say, state: wire.State) -> SpeechWatch:
        """Follows what was said from now on. state: the first that knows of it."""
        watch = SpeechWatch(said.key, said.character, state, said.sound)
        self._watches.append(watch)
        return watch

    def note(self, state: wire.State) -> None:
        """Follows a newer state."""
        for watch in self._watches:
            watch.note(state)
        self._watches = [watch for watch in self._watches if watch.spoken is None]

    def sounds(self) -> Iterator[str]:
        """The keys of the sounds that are needed, the first first."""
        return (watch.sound for watch in self._watches if watch.sound)
