"""Texts that a voice is to speak for characters: who asked, and whether that is still wanted once it has spoken."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass

from omote.show.objects.speech import SayByVoice


@dataclass(frozen=True, eq=False)
class TextToSpeak:
    """What a voice is asked to say. who: the client that asked; characters: who is to say it."""

    who: str
    message: SayByVoice
    characters: tuple[str, ...]


class TextsToSpeak:
    """The texts that are asked for; the server has them spoken between ticks, and says them then."""

    def __init__(self) -> None:
        self._new: list[TextToSpeak] = []
        self._wanted: list[TextToSpeak] = []
        self._refused: list[tuple[TextToSpeak, str]] = []

    def ask(self, text: TextToSpeak) -> None:
        """Asks for a text, in the place of those that its characters wait for."""
        self.drop(text.characters)
        self._new.append(text)
        self._wanted.append(text)

    def drop(self, characters: Collection[str]) -> None:
        """Forgets the texts that any of these characters waits for: it was stopped, or says something else."""
        self._wanted = [text for text in self._wanted if not set(text.characters) & set(characters)]
        self._new = [text for text in self._new if text in self._wanted]

    def take(self) -> list[TextToSpeak]:
        """Returns and clears the texts that no voice has been given yet."""
        texts = self._new
        self._new = []
        return texts

    def finish(self, text: TextToSpeak, refusal: str = "") -> bool:
        """Whether a text is still wanted, which is no more from then on; refusal: why a voice did not speak it."""
        wanted = text in self._wanted
        if wanted:
            self._wanted.remove(text)
            if refusal:
                self.refuse(text, refusal)
        return wanted

    def refuse(self, text: TextToSpeak, reason: str) -> None:
        """Notes why (reason) a text was not said, for who asked."""
        self._refused.append((text, reason))

    def take_refused(self, is_told: Callable[[str], bool]) -> list[tuple[TextToSpeak, str]]:
        """Returns and clears the texts that were not spoken with the reasons, of clients for which `is_told` holds."""
        told = [(text, reason) for text, reason in self._refused if is_told(text.who)]
        self._refused = [pair for pair in self._refused if pair not in told]
        return told
