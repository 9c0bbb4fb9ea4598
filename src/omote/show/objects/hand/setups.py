"""Set-ups: how a puppeteer plays, mappings and bindings together, kept under a name and changed in one press."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Annotated, ClassVar

import msgspec

from omote.perform.limits import check_known
from omote.perform.mappings.mapping import MacroMapping
from omote.perform.mappings.renamed_pads import mapping_after_rename
from omote.show.declaration import CallId, DeviceMessage, Outgoing, ServerMessage, Session
from omote.show.objects.bindings import BindingDocument, address_after_rename
from omote.show.objects.documents import Document
from omote.show.osc import PRESS, Value, osc

LONGEST_SETUP_NAME = 40
SetupName = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_SETUP_NAME), Value("text")]


class StoredSetup(Document, frozen=True):
    """The mappings of all characters, by their names, and the bindings of all devices."""

    kind: ClassVar[str] = "setup"
    most: ClassVar[int] = 32

    mappings: dict[str, list[MacroMapping]] = msgspec.field(default_factory=dict)
    bindings: list[BindingDocument] = msgspec.field(default_factory=list)

    def after_rename(self, pad: str, to: str) -> StoredSetup:
        """The set-up with another name for a pad. pad: its name before; to: its name now."""
        mappings = {
            character: [mapping_after_rename(mapping, pad, to) for mapping in mappings]
            for character, mappings in self.mappings.items()
        }
        bindings = [
            msgspec.structs.replace(binding, to=address_after_rename(binding.to, pad, to)) for binding in self.bindings
        ]
        return msgspec.structs.replace(self, mappings=mappings, bindings=bindings)

    def names(self) -> Iterable[str]:
        """The characters whose macros it has, the channels that they play, and what its bindings call."""
        yield from self.mappings
        for mappings in self.mappings.values():
            yield from (target.place[1] for mapping in mappings for target in mapping.targets)
        for binding in self.bindings:
            yield from (argument for argument in binding.arguments if isinstance(argument, str))


class SetupMessage(DeviceMessage, frozen=True):
    """What a page or a program asks of set-ups; each executes once, and is answered by `setup_changed`."""

    method = ""


class KeepSetup(SetupMessage, frozen=True):
    """Keeps all mappings and all bindings as they are under a name; one of that name is kept anew. An `id` executes
    once."""

    id: CallId
    name: SetupName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps it for the next tick. session: the show; who: the client; now: seconds, monotonic."""
        session.setups.add(self.name)  # one who calls it before the next tick finds it
        return super().act(session, who, now)


class CallSetup(SetupMessage, frozen=True):
    """Plays by a set-up from now on: its mappings and its bindings in the place of all that there are. Nothing jumps:
    macros that are still there stay where they are, what others gave fades out in .2 s, and faders wait to be picked
    up. `restore_setup` with this `id` takes it back."""

    osc = (osc("setup/{name}", "plays by a set-up, when it is pressed", PRESS, of_show=True),)

    id: CallId
    name: SetupName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps it for the next tick. session: the show; who: the client; now: seconds, monotonic."""
        check_known(self.name, session.setups, "set-up")
        return super().act(session, who, now)


class DropSetup(SetupMessage, frozen=True):
    """Forgets a set-up; what plays goes on. `restore_setup` with this `id` takes it back."""

    id: CallId
    name: SetupName

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Keeps it for the next tick. session: the show; who: the client; now: seconds, monotonic."""
        check_known(self.name, session.setups, "set-up")
        return super().act(session, who, now)


class RestoreSetup(SetupMessage, frozen=True):
    """Takes back what the message of the id `change` did: what was kept under the name, or what played, is as before
    it; that can be taken back itself."""

    id: CallId
    change: CallId


class SetupList(ServerMessage, frozen=True):
    """The names of all set-ups, in the order in which they were kept first: complete, to consoles after the welcome and
    with each change. `called`: the one that was called last, "" where mappings or bindings have changed since."""

    names: list[str]
    called: str = ""


class SetupChanged(ServerMessage, frozen=True):
    """Answers a message about set-ups. `missing`: characters of it that are not there, whose macros are left out."""

    id: str
    name: str
    missing: list[str] = []
