"""Cues: what one GO plays, the lists in which they stand, and who plays and edits them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any, ClassVar, Literal

import msgspec

from omote.perform.cues.cue import LONGEST_TEXT, Cue, GoesOn
from omote.perform.cues.cue_action import CueAction, SpokenLine
from omote.perform.easing import DEFAULT_EASING
from omote.perform.scene.character_names import ALL
from omote.perform.scene.clip_goals import clip_of_goal
from omote.perform.scene.framings import names_in
from omote.perform.scene.goals import MACROS, Part, passes, ranges_of, split_part
from omote.perform.scene.look_goals import name_in
from omote.perform.scene.pad_goals import is_pad_goal
from omote.show.declaration import SPEECH_LIMIT, CallId, ClientMessage, Name, Outgoing, Session
from omote.show.objects.documents import Document
from omote.show.osc import PRESS, Argument, Osc, Value, osc

CueNumber = Annotated[str, msgspec.Meta(max_length=9), Value("cue", name="cue")]
StandbyNumber = Annotated[str, msgspec.Meta(max_length=9), Value("cue", default="", name="cue")]
Identity = Annotated[str, msgspec.Meta(min_length=1, max_length=24)]
OptionalIdentity = Annotated[str, msgspec.Meta(max_length=24)]
ListName = Annotated[str, msgspec.Meta(max_length=40)]
CUE_LIST_PATH = "/cue_lists/{name}"
MOST_RECORDED = 200
"""Parts that one message asks to record."""


# --- what is stored ---


class StoredCue(Document, frozen=True):
    """A cue, under its identity."""

    kind: ClassVar[str] = "cue"

    cue: Cue

    def names(self) -> Iterable[str]:
        """The faces, expressions and characters that its moves name."""
        return _named_by(self.cue)


class StoredCueList(Document, frozen=True):
    """A list of cues, under its name: the identities of its cues in the order of GO, and its place among the lists."""

    kind: ClassVar[str] = "cue_list"

    order: list[str]
    place: int = 0


class CueEdit(Document, frozen=True, omit_defaults=True):
    """An edit of cues, under its number: what was done, by whom, and the cues (by identity) and orders (by list) that
    it found and left; None for what is not there. `undo` takes the last edit back that stands, `redo` does it again:
    they have nothing of their own. Nothing is taken back across one that is `unreadable`."""

    kind: ClassVar[str] = "cue_edit"

    what: str
    by: str
    does: Literal["edit", "undo", "redo", "unreadable"] = "edit"
    cues_before: dict[str, Cue | None] = {}
    cues_after: dict[str, Cue | None] = {}
    orders_before: dict[str, list[str] | None] = {}
    orders_after: dict[str, list[str] | None] = {}

    def names(self) -> Iterable[str]:
        """The faces, expressions and characters that cues of before or after it name."""
        both = (*self.cues_before.values(), *self.cues_after.values())
        return (name for cue in both if cue is not None for name in _named_by(cue))


def _named_by(cue: Cue) -> Iterable[str]:
    lines = [action.to for action in cue.actions if isinstance(action.meant, SpokenLine)]
    yield from (character for character in lines if character != ALL)
    for part, move in cue.moves.items():
        character, name = split_part(part)
        if character != ALL:
            yield character
        if name == "framing":
            yield from (each for framing in move.goal for each in names_in(framing))
        elif name == "look":
            yield from [looked] if (looked := name_in(dict(move.goal))) else []
        elif passes(part):
            yield from [clip_of_goal(move.goal).name] if move.goal else []
        elif ranges_of(part) is None and name not in ("light", MACROS) and not is_pad_goal(part, move.goal):
            yield from move.goal


# --- what plays them ---


def _of_cues(read: Callable[[CueStatus], Argument]) -> dict[str, Any]:
    """What surfaces are told of the cues, once there is a list. read: the value of it."""
    return {
        "on_air": lambda state: () if state.cues is None else (read(state.cues),),
        "reported": lambda state: () if state.cues is None else ((),),
    }


def _number_of(cue: CueName | None) -> str:
    return "" if cue is None else cue.number


class CuePlay(ClientMessage, frozen=True):
    """What plays cues: who does holds `cues`, where leases are on."""

    access = "operate"
    plays = "cues"
    method: ClassVar[str | None] = ""


class Go(CuePlay, frozen=True):
    """Calls the cue that stands by, or the one of a number (`cue`), each once however often the message comes. `seen`:
    the identity of the cue that its presser saw standing by; where another does, nothing is called, and every console
    reads so. While cues are paused it lets them go on instead. An `id` executes once, as of all that follow.
    `cue_list`: of several lists; "" for the one that is chosen."""

    method = "go"
    osc = (
        Osc(
            "go",
            "calls the cue that stands by, or that of a number; told: the number of the one that was called last",
            ("cue",),
            of_show=True,
            **_of_cues(lambda cues: _number_of(cues.lists[cues.chosen].current)),
        ),
    )

    id: CallId
    cue: StandbyNumber = ""
    seen: OptionalIdentity = ""
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        return session.cues.go(self, who, now)  # type: ignore[no-any-return]


class GoBack(CuePlay, frozen=True):
    """Brings back what stood before the last cue was called, in a second; that cue stands by again."""

    method = "back"
    osc = (osc("back", "brings back what stood before the last cue", PRESS, of_show=True),)

    id: CallId
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        return session.cues.go_back(self, who, now)  # type: ignore[no-any-return]


class GoToCue(CuePlay, frozen=True):
    """Calls a cue out of its order; what waits is forgotten. `whole`: with all that the cues before it leave
    standing."""

    osc = (
        osc("go_to", "calls a cue out of its order", "cue", of_show=True),
        osc("load", "the same with all that the cues before it leave standing", "cue", of_show=True, whole=True),
    )

    id: CallId
    cue: CueNumber
    whole: bool = False
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        return session.cues.go_to(self, who, now)  # type: ignore[no-any-return]


class AssertLook(CuePlay, frozen=True):
    """Calls all that the cues have left standing again, whoever has moved it since, in a second."""

    osc = (osc("assert", "calls all that the cues have left standing again", PRESS, of_show=True),)

    id: CallId
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        return session.cues.assert_look(self, who, now)  # type: ignore[no-any-return]


class SetStandby(CuePlay, frozen=True):
    """Has another cue stand by; nothing moves."""

    osc = (
        Osc(
            "standby",
            "has another cue stand by; nothing moves",
            ("cue",),
            of_show=True,
            **_of_cues(lambda cues: _number_of(cues.lists[cues.chosen].standby)),
        ),
    )

    id: CallId
    cue: CueNumber
    cue_list: ListName = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        session.cues.set_standby(self)
        return ()


class PauseCues(CuePlay, frozen=True):
    """Pauses the cues of all lists, or lets them go on: their waits, what follows, and what they have called comes to a
    stand in .2 s. Hands, trackers and what moves by itself go on."""

    osc = (
        Osc(
            "pause",
            "pauses the cues (1), or lets them go on (0)",
            ("on",),
            of_show=True,
            **_of_cues(lambda cues: float(cues.rate < 1.0)),
        ),
    )

    id: CallId
    on: Annotated[bool, Value("switch", default=1.0)] = True

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Plays it. session: the show; who: the client; now: seconds, monotonic."""
        session.cues.pause(on=self.on)
        return ()


class ChooseCueList(CuePlay, frozen=True):
    """Chooses the list that is meant where a message names none."""

    osc = (
        Osc(
            "cue_list",
            "chooses the list of cues that GO plays",
            ("cue_list",),
            of_show=True,
            **_of_cues(lambda cues: cues.chosen),
        ),
    )

    id: CallId
    cue_list: Annotated[Name, Value("text")]

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Chooses it. session: the show; who: the client; now: seconds, monotonic."""
        session.cues.choose(self.cue_list)
        return ()


# --- what edits them ---


class CueCommand(ClientMessage, frozen=True):
    """An edit of cues: nothing moves on air by it. `cue_list`: as of `go`."""

    access = "edit"
    recorded = False
    method: ClassVar[str | None] = ""

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Edits the cues. session: the show; who: the client; now: seconds, monotonic."""
        is_preview = session.members.looks_at(who) == "preview"
        looked_at = (session.preview.looked_at,) if is_preview else ()
        recorded = session.cues.edit(self, who, session.scene_of(who), *looked_at)
        if is_preview and recorded is not None:
            session.preview.go_on_at(recorded)
        return ()


class PutCue(CueCommand, frozen=True):
    """Writes a new cue, or changes what is given of the one of an identity (`cue`). `number`: "" for the next free one;
    `actions`: all that it sends and has said; `after`: the identity of the cue that a new one comes behind, "" for
    where its number belongs."""

    longest = SPEECH_LIMIT

    id: CallId
    cue: OptionalIdentity = ""
    number: Annotated[str, msgspec.Meta(max_length=9)] | None = None
    label: Annotated[str, msgspec.Meta(max_length=LONGEST_TEXT["label"])] | None = None
    note: Annotated[str, msgspec.Meta(max_length=LONGEST_TEXT["note"])] | None = None
    colour: Annotated[str, msgspec.Meta(max_length=LONGEST_TEXT["colour"])] | None = None
    pre_wait: float | None = None
    post_wait: float | None = None
    goes_on: GoesOn | None = None
    skip: bool | None = None
    actions: list[CueAction] | None = None
    after: OptionalIdentity = ""
    cue_list: ListName = ""


class PutMove(CueCommand, frozen=True):
    """Writes the move of a part in a cue (an identity), or takes its place. `goal`: a mix, or numbers by name; as of
    the parts of cues."""

    id: CallId
    cue: Identity
    part: Name
    goal: dict[str, float]
    seconds: float = 1.0
    easing: Name = DEFAULT_EASING
    delay: float = 0.0


class DropMove(CueCommand, frozen=True):
    """Takes the move of a part out of a cue (an identity)."""

    id: CallId
    cue: Identity
    part: Name


class RecordCue(CueCommand, frozen=True):
    """Writes a new cue of what shows to its sender, on air or in preview: the parts that stand otherwise than the cues
    before it leave them, or those that `parts` names (`one/face`, `one` for all of a character). `number`: "" for the
    next free one behind the cue that was called last, in preview behind the one that is looked at, which is the new one
    from then on."""

    osc = (osc("record_cue", "writes a new cue of what shows", "cue", of_show=True),)

    id: CallId
    cue: StandbyNumber = ""
    label: Annotated[str, msgspec.Meta(max_length=LONGEST_TEXT["label"])] = ""
    seconds: float = 1.0
    parts: Annotated[list[Name], msgspec.Meta(max_length=MOST_RECORDED)] = []
    cue_list: ListName = ""


class UpdateCue(CueCommand, frozen=True):
    """Writes what shows to its sender, on air or in preview, into a cue (an identity; "" for the one that was called
    last, in preview for the one that is looked at): each part that stands otherwise than the list leaves it there."""

    osc = (osc("update_cue", "writes what shows into the cue that was called last", PRESS, of_show=True),)

    id: CallId
    cue: OptionalIdentity = ""
    cue_list: ListName = ""


class CopyCue(CueCommand, frozen=True):
    """Copies a cue (an identity) behind itself, or behind another (`after`), under the next free number."""

    id: CallId
    cue: Identity
    after: OptionalIdentity = ""


class MoveCue(CueCommand, frozen=True):
    """Moves a cue (an identity) behind another one of its list (`after`; "" for the first place); its number stays."""

    id: CallId
    cue: Identity
    after: OptionalIdentity = ""


class DropCue(CueCommand, frozen=True):
    """Takes a cue (an identity) out of its list."""

    id: CallId
    cue: Identity


class RenumberCues(CueCommand, frozen=True):
    """Numbers the cues of a list anew, in their order: `first`, then each by `step` more."""

    id: CallId
    first: Annotated[str, msgspec.Meta(max_length=9)] = "1"
    step: Annotated[str, msgspec.Meta(max_length=9)] = "1"
    cue_list: ListName = ""


class AddCueList(CueCommand, frozen=True):
    """Begins a list of cues."""

    id: CallId
    cue_list: Name


class RenameCueList(CueCommand, frozen=True):
    """Gives a list of cues another name."""

    id: CallId
    cue_list: Name
    to: Name


class DropCueList(CueCommand, frozen=True):
    """Takes a list with its cues out of the show; the last one stays."""

    id: CallId
    cue_list: Name


class UndoCues(CueCommand, frozen=True):
    """Takes the last edit of cues back, whoever made it; again, the one before it. `seen`: how many edits its presser
    saw in `CueStatus.edits`; where there are others now, nothing is taken back."""

    id: CallId
    seen: int | None = None


class RedoCues(CueCommand, frozen=True):
    """Does the edit again that was taken back last. `seen`: as of `undo_cues`."""

    id: CallId
    seen: int | None = None


class SetShowMode(ClientMessage, frozen=True):
    """Locks the cues for a performance, or opens them: while the show mode is on nobody edits them."""

    access = "admin"
    method = ""

    id: CallId
    on: bool

    def act(self, session: Session, who: str, now: float) -> Sequence[Outgoing]:
        """Locks or opens them. session: the show; who: the client; now: seconds, monotonic."""
        session.cues.locked = self.on
        return ()


# --- what is told of them ---


class CueName(msgspec.Struct, frozen=True):
    """A cue as consoles name it."""

    identity: str
    number: str
    label: str = ""
    note: str = ""
    colour: str = ""


class CueWait(msgspec.Struct, frozen=True):
    """A move that waits: the number of its cue, its part, and in how many seconds it is called."""

    number: str
    part: Part
    seconds: float


class CueMotion(msgspec.Struct, frozen=True):
    """A part that is moved: the number of the cue that moves it, or the `act` that does, "Back" or "Assert", and in how
    many seconds it arrives."""

    number: str
    part: Part
    seconds: float
    act: str = ""


class CueListStatus(msgspec.Struct, frozen=True):
    """How far a list is. `current`: the cue that was called last; `standby`: the one that GO calls; `waits`, `moving`:
    the next first; `follows`: the cue that follows by itself, in `follows_in` seconds; `since`: seconds since
    somebody pressed last, None before that; `pressed`: what that was ("GO 12", "Back", "Assert" or "Go to 12"), `by`
    whom."""

    current: CueName | None
    standby: CueName | None
    waits: list[CueWait] = []
    moving: list[CueMotion] = []
    follows: CueName | None = None
    follows_in: float = 0.0
    since: float | None = None
    by: str = ""
    pressed: str = ""


class CueStatus(msgspec.Struct, frozen=True):
    """The lists of cues by name, in their order. `chosen`: the one that is meant where none is named; `rate`: of their
    time, 0 paused; `edits`: how many edits there were: `/cue_lists/NAME` has the cues; `undo`, `redo`: what would be
    taken back or done again, "" for nothing. `ignored`: the last GO that was not obeyed, and why, with the number of
    such; `rejected`: what of the last cue could not be called. `locked`: the show mode is on."""

    chosen: str
    lists: dict[str, CueListStatus]
    rate: float = 1.0
    edits: int = 0
    undo: str = ""
    redo: str = ""
    ignored: str = ""
    ignored_count: int = 0
    rejected: list[str] = []
    locked: bool = False


class CueListDocument(msgspec.Struct, frozen=True):
    """A list of cues as `/cue_lists/NAME` returns it (JSON): its cues in the order of GO. `edits`: as of
    `CueStatus`."""

    edits: int
    cues: list[Cue]
