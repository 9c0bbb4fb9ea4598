"""What pages ask of set-ups: kept, called, forgotten, taken back; a call changes mappings and bindings at once."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import msgspec

from omote.inputs.bindings.binding_document import document_of, read_document
from omote.inputs.bindings.control_binding import Binding
from omote.inputs.page_devices.binding_commands import BindingCommands
from omote.perform.limits import check_known
from omote.perform.mappings.mapping import MacroMapping
from omote.perform.mappings.renamed_pads import mapping_after_rename
from omote.show.declaration import SPEECH_LIMIT
from omote.show.objects.documents import read_document as read_stored
from omote.show.objects.hand.macros import SetMappings
from omote.show.objects.hand.setups import (
    CallSetup,
    DropSetup,
    KeepSetup,
    RestoreSetup,
    SetupChanged,
    SetupList,
    SetupMessage,
    StoredSetup,
)
from omote.show.session import ShowSession

REMEMBERED_CHANGES = 32
MOST_BYTES = SPEECH_LIMIT - 1024
"""Of the mappings of a character: one message sets them, and has names beside them."""
KeepSetups = Callable[[str, bytes | None], None]
"""Stores the set-up of a name in the show file; None takes it out."""
Played = Mapping[str, Mapping[str, MacroMapping]]
"""The mappings of characters, by their names."""


@dataclass(frozen=True)
class _Kept:
    """What a name stood for before a change; None for nothing."""

    name: str
    setup: StoredSetup | None


@dataclass(frozen=True)
class _Called:
    """What played before a set-up was called, and the id under which the bindings were changed."""

    mappings: Played
    bindings: str
    called: str


class SetupCommands:
    """The set-ups of a show. session: the one that runs; commands: of its bindings; stored: the set-ups of its file
    (JSON), by name; keep: takes what the file is to keep. number: rises with each change."""

    def __init__(
        self,
        session: Callable[[], ShowSession],
        commands: BindingCommands,
        stored: Mapping[str, bytes] | None = None,
        keep: KeepSetups = lambda _name, _body: None,
    ) -> None:
        self._session = session
        self._commands = commands
        self._keep = keep
        self._setups = dict[str, StoredSetup]()
        self._before = dict[str, _Kept | _Called]()
        self._called = ""
        self._played: object = None
        self.unreadable: list[str] = []
        self.number = int(bool(stored))
        for name, body in (stored or {}).items():
            try:
                self._setups[name] = read_stored(StoredSetup, body)
            except ValueError as error:
                self.unreadable.append(f"the set-up {name} in the show file cannot be read ({error}); it is left there")

    def carry_out(self, who: str, message: SetupMessage, now: float) -> SetupChanged:
        """Does what a page asks for; ValueError where it cannot be, and nothing has changed.

        who: the page; message: what it asks for; now: seconds of the show's clock.
        """
        self.number += 1
        match message:
            case KeepSetup(change, name):
                return self._put(change, name.strip(), self._now())
            case CallSetup(change, name):
                setup = self._setups[check_known(name, self._setups, "set-up")]
                mappings = {who: {each.name: each for each in kept} for who, kept in setup.mappings.items()}
                return self._call(who, change, name, mappings, setup, now)
            case DropSetup(change, name):
                return self._put(change, check_known(name, self._setups, "set-up"), None)
            case RestoreSetup(change, earlier):
                before = self._before.get(earlier)
                if before is None:
                    raise ValueError("that change of a set-up cannot be taken back any more: it was long ago")
                if isinstance(before, _Kept):
                    return self._put(change, before.name, before.setup)
                return self._call(who, change, before.called, before.mappings, before.bindings, now)
        raise ValueError(f"nothing is known of {type(message).__name__}")

    def rename_pad(self, pad: str, to: str) -> None:
        """Has set-ups follow a pad to another name, and what of them can be taken back.

        pad: its name before; to: its name now.
        """
        for name, setup in self._setups.items():
            later = setup.after_rename(pad, to)
            if later != setup:
                self._setups[name] = later
                self._keep(name, later.encode())
                self.number += 1
        for change, before in self._before.items():
            if isinstance(before, _Called):
                mappings = {
                    character: {name: mapping_after_rename(each, pad, to) for name, each in played.items()}
                    for character, played in before.mappings.items()
                }
                self._before[change] = replace(before, mappings=mappings)
            elif before.setup is not None:
                self._before[change] = replace(before, setup=before.setup.after_rename(pad, to))
        if self._called:
            self._played = self._playing()

    def list_now(self) -> SetupList:
        """All set-ups, for pages."""
        return SetupList([*self._setups], self._called)

    def look(self) -> None:
        """Notes whether what plays has changed since a set-up was called, and tells the session which there are."""
        self._session().setups = {*self._setups}
        if self._called and self._playing() != self._played:
            self._called = ""
            self.number += 1

    def _now(self) -> StoredSetup:
        scene = self._session().scene
        mappings = {name: [*scene[name].mappings.values()] for name in scene if scene[name].mappings}
        for name, kept in mappings.items():
            if (size := len(msgspec.msgpack.encode(kept))) > MOST_BYTES:
                raise ValueError(f"the macros of {name} take {size} bytes; a set-up keeps {MOST_BYTES}, drop some")
        return StoredSetup(mappings, [document_of(binding) for binding in self._commands.editable.own])

    def _playing(self) -> object:
        scene = self._session().scene
        return tuple((name, scene[name].mappings) for name in scene), self._commands.editable.own

    def _put(self, change: str, name: str, setup: StoredSetup | None) -> SetupChanged:
        """Keeps a set-up under a name, or forgets the one of it."""
        if not name:
            raise ValueError("a set-up needs a name; give 1 to 40 letters")
        if setup is not None and name not in self._setups and len(self._setups) >= StoredSetup.most:
            raise ValueError(f"there are {StoredSetup.most} set-ups, which is as many as a show keeps; delete one")
        self._remember(change, _Kept(name, self._setups.get(name)))
        if setup is None:
            del self._setups[name]
        else:
            self._setups[name] = setup
        self._keep(name, None if setup is None else setup.encode())
        self._note_called("" if setup is None else name)
        return SetupChanged(change, name)

    def _call(
        self, who: str, change: str, name: str, mappings: Played, bindings: StoredSetup | str, now: float
    ) -> SetupChanged:
        """Plays by other mappings and other bindings. bindings: of a set-up, or the change of them to be taken back."""
        scene = self._session().scene
        before = _Called({each: scene[each].mappings for each in scene}, change, self._called)
        if isinstance(bindings, str):
            self._commands.restore(change, bindings)
        else:
            self._commands.give_all(change, [each for document in bindings.bindings for each in _read(document)])
        for character, playing in before.mappings.items():
            wanted = mappings.get(character, {})
            if wanted != playing:  # by a message, so that a recording of the show has it
                call = f"{change[-32:]} {character}"
                self._session().receive(who, SetMappings(character, call, [*wanted.values()], call), now)
        self._remember(change, before)
        self._note_called(name)
        return SetupChanged(change, name, [character for character in mappings if character not in before.mappings])

    def _remember(self, change: str, before: _Kept | _Called) -> None:
        self._before[change] = before
        if len(self._before) > REMEMBERED_CHANGES:
            del self._before[next(iter(self._before))]

    def _note_called(self, name: str) -> None:
        self._called = name
        self._played = self._playing()


def _read(document: object) -> list[Binding]:
    """The binding of a document; none of one that this Omote cannot play."""
    try:
        return [read_document(document)]  # type: ignore[arg-type]
    except ValueError:
        return []
