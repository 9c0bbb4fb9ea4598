"""What the show file keeps of sounds: read at the start, and written after each change, with their bytes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from omote.inputs.sounds.sound_file import SoundFile
from omote.show.objects.sounds import StoredSound
from omote.show.session import ShowSession
from omote.show.speech.named_sounds import read_sounds
from omote.showfile.changes import Change, Content, ContentRemoval, DocumentRemoval, StoredDocument, content_key


class SoundStore:
    """Keeps the named sounds of a session, and has their bytes."""

    def __init__(self, session: ShowSession) -> None:
        self._session = session
        self._contents: dict[str, bytes] = {}
        self._written: frozenset[str] = frozenset()

    def load(
        self,
        documents: Callable[[str], Mapping[str, bytes]],
        contents: Mapping[str, bytes],
        report: Callable[[str], None],
    ) -> None:
        """Has the sounds of the show file. documents: of a kind, by name; contents: their bytes, by key; report: tells
        the operator what of it cannot be read."""
        sounds, lost = read_sounds(documents(StoredSound.kind), contents)
        self._contents = {sound.content: contents[sound.content] for sound in sounds.values()}
        self._written = frozenset(self._contents)
        self._session.named_sounds.load(sounds)
        for sentence in lost:
            report(sentence)

    def add(self, name: str, sound: SoundFile, *, replace: bool) -> str:
        """Keeps a sound under a name, and returns it; ValueError where it cannot be kept. replace: it takes the place
        of the one of that name."""
        content = content_key(sound.data)
        stored = StoredSound(sound.key, sound.seconds, content, len(sound.data))
        called = self._session.named_sounds.add(name, stored, replace=replace)
        self._contents[content] = sound.data
        return called

    def find(self, key: str) -> bytes | None:
        """The bytes of a sound of the show by its key, None where it is none; from any thread."""
        sounds = self._session.named_sounds.sounds
        content = next((sound.content for sound in sounds.values() if sound.sound == key), "")
        return self._contents.get(content)

    def keep(self, commit: Callable[[Sequence[Change]], None]) -> None:
        """Writes what was changed since the last tick, in one commit. commit: writes changes into the show file."""
        changed = self._session.named_sounds.take_changes()
        if changed:
            commit([*self._changed_bytes(), *_changed_documents(changed)])

    def _changed_bytes(self) -> list[Change]:
        """What comes into the file and what leaves it; what can be brought back stays here alone."""
        named = self._session.named_sounds
        wanted = frozenset(sound.content for sound in named.sounds.values())
        come = [Content(key, self._contents[key]) for key in sorted(wanted - self._written)]
        gone = [ContentRemoval(key) for key in sorted(self._written - wanted)]
        self._written = wanted
        needed = wanted | {sound.content for sound in named.dropped.values()}
        self._contents = {key: data for key, data in self._contents.items() if key in needed}
        return [*come, *gone]


def _changed_documents(sounds: Mapping[str, StoredSound | None]) -> Iterable[Change]:
    for name, sound in sounds.items():
        if sound is None:
            yield DocumentRemoval(StoredSound.kind, name)
        else:
            yield StoredDocument(StoredSound.kind, name, sound.encode())
