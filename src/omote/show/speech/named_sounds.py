"""The sounds that a show file keeps: by name, edited in the session and written after the tick, as clips are."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Mapping

import msgspec
from msgspec import structs

from omote.perform.clips.clip import Clip
from omote.perform.limits import check_free, check_known
from omote.perform.newest_entries import with_newest
from omote.show.cues.cue_book import CueBook
from omote.show.objects.speech import (
    LONGEST_SOUND_NAME,
    MOST_NAMED_BYTES,
    MOST_NAMED_SOUNDS,
    NamedSound,
    Sounds,
    StoredSound,
)

MOST_DROPPED = 8
"""Sounds that can be brought back."""
_KEY = re.compile("[0-9a-f]{32}")


class NamedSounds:
    """The sounds of a show, by name. changed: called after each change."""

    def __init__(self, changed: Callable[[], None] = lambda: None) -> None:
        self._changed = changed
        self.sounds: Mapping[str, StoredSound] = {}
        self.dropped: Mapping[str, StoredSound] = {}
        self._kept: Mapping[str, StoredSound] = {}

    def load(self, sounds: Mapping[str, StoredSound]) -> None:
        """Has the sounds of a show file."""
        self._kept = dict(sounds)
        self._set(self._kept)

    def take_changes(self) -> dict[str, StoredSound | None]:
        """Returns what the show file does not have yet, by name; None for what is gone."""
        before = self._kept
        now = self.sounds
        self._kept = now
        return {name: now.get(name) for name in {**before, **now} if now.get(name) != before.get(name)}

    def called(self) -> dict[str, str]:
        """The keys of the sounds by all that they may be called: names, and those of before that no other one has."""
        former = {name: sound.sound for sound in self.sounds.values() for name in sound.former}
        return {**former, **{name: sound.sound for name, sound in self.sounds.items()}}

    def seconds(self) -> dict[str, float]:
        """How long each is, by its key."""
        return {sound.sound: sound.seconds for sound in self.sounds.values()}

    def message(self) -> Sounds:
        """What consoles are told of them."""
        named = sorted(self.sounds.items())
        return Sounds([NamedSound(name, each.sound, each.seconds, list(each.former)) for name, each in named])

    def check_room(self, name: str, size: int, *, replace: bool) -> str:
        """Returns the name of a new sound without spaces around it; ValueError where it cannot be called so, or the
        show has no room for it. size: its bytes; replace: it takes the place of the one of that name."""
        text = check_sound_name(name)
        if text in self.sounds and not replace:
            raise ValueError(f"there is a sound {text!r} already; give another name, or replace it")
        others = {each: sound for each, sound in self.sounds.items() if each != text}
        if text not in self.sounds:
            check_free(text, others, "sound")
        if len(others) >= MOST_NAMED_SOUNDS:
            raise ValueError(f"there are {len(others)} sounds, which is as many as a show keeps; delete one")
        used = sum(sound.size for sound in others.values())
        if used + size > MOST_NAMED_BYTES:
            raise ValueError(
                f"the sounds of a show take {MOST_NAMED_BYTES} bytes at most: {used} are taken, and this one has "
                f"{size}; send it as MP3 or Ogg, or delete one"
            )
        return text

    def add(self, name: str, sound: StoredSound, *, replace: bool = False) -> str:
        """Keeps a sound, and returns under which name; ValueError as of `check_room`. sound: with the keys of its
        bytes; replace: it takes the place of the one of that name, which can be brought back once this is dropped."""
        text = self.check_room(name, sound.size, replace=replace)
        before = self.sounds.get(text)
        if before is not None and before.sound != sound.sound:
            self._lay_aside(text, before)
        former = () if before is None else before.former
        self._set({**self.sounds, text: structs.replace(sound, former=former)})
        return text

    def rename(self, name: str, to: str) -> None:
        """Gives a sound another name (to); ValueError where there is none of that name, or another has it."""
        sound = self.sounds[check_known(name, self.sounds, "sound")]
        text = check_sound_name(to)
        others = {each: other for each, other in self.sounds.items() if each != name}
        check_free(text, others, "sound")
        former = tuple(dict.fromkeys(each for each in (*sound.former, name) if each != text))
        self._set({**others, text: structs.replace(sound, former=former)})

    def drop(self, name: str, clips: Mapping[str, Clip], book: CueBook) -> list[str]:
        """Takes the sound of a name out; returns who needs it, in words. clips, book: those of the show."""
        sound = self.sounds[check_known(name, self.sounds, "sound")]
        called = {each for each, key in self.called().items() if key == sound.sound}
        self._lay_aside(name, sound)
        self._set({each: other for each, other in self.sounds.items() if each != name})
        left = {*self.called(), *self.seconds()}
        return list(who_needs({*called, name, sound.sound} - left, clips, book))

    def restore(self, name: str) -> None:
        """Brings back the sound that was dropped last under a name; ValueError where none was, or another has it."""
        sound = self.dropped[check_known(name, self.dropped, "dropped sound")]
        self.check_room(name, sound.size, replace=False)
        self._set({**self.sounds, name: sound})

    # --- within ---

    def _lay_aside(self, name: str, sound: StoredSound) -> None:
        self.dropped = with_newest(self.dropped, name, sound, MOST_DROPPED)

    def _set(self, sounds: Mapping[str, StoredSound]) -> None:
        self.sounds = sounds
        self._changed()


def who_needs(called: Collection[str], clips: Mapping[str, Clip], book: CueBook) -> Iterable[str]:
    """The clips and the cues that name a sound, in words. called: what it is called, its key too; clips, book: those of
    the show."""
    yield from (f"the clip {name}" for name, clip in clips.items() if clip.sound in called)
    for cues in book.orders:
        for cue in book.cues_of(cues):
            if any(action.does == "say" and action.sound in called for action in cue.actions):
                yield f"the cue {cue.number} of {cues}"


def check_sound_name(name: str) -> str:
    """Returns the name of a sound without spaces around it; ValueError for none, for one that is too long, and for one
    that looks like a key."""
    text = " ".join(name.split())
    if not 0 < len(text) <= LONGEST_SOUND_NAME or not text.isprintable() or _KEY.fullmatch(text):
        raise ValueError(
            f"a sound cannot be called {name!r:.80}; give 1 to {LONGEST_SOUND_NAME} printable letters, no key of 32 "
            "hexadecimal digits"
        )
    return text


def read_sounds(documents: Mapping[str, bytes], contents: Collection[str]) -> tuple[dict[str, StoredSound], list[str]]:
    """The sounds that a show file keeps, and which cannot be read, in sentences: one costs itself.

    documents: those (JSON) of the kind, by name; contents: the keys of all bytes that are there.
    """
    sounds = dict[str, StoredSound]()
    lost = list[str]()
    for name, body in documents.items():
        try:
            sound = msgspec.json.decode(body, type=StoredSound)
        except (ValueError, TypeError, RecursionError) as error:
            lost.append(f"the sound {name} cannot be read ({error}) and is left out.")
            continue
        if sound.content in contents:
            sounds[name] = sound
        else:
            lost.append(f"the sound {name} has no bytes in the show file and is left out.")
    return sounds, lost
