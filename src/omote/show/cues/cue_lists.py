"""The cue lists of a session: what GO and its kin are let through to play, and what consoles are told of it."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from omote.perform.cues.cue import Cue, CueList
from omote.perform.cues.cue_action import MidiSend, OscSend, SpokenLine
from omote.perform.cues.cue_names import named_cue, named_cues
from omote.perform.cues.cue_player import CuePlayer, advance_lists
from omote.perform.cues.cue_state import ASSERT, BACK, GAP_SECONDS, CueState, edited
from omote.perform.cues.renamed_pads import cue_after_rename, moves_pad, state_after_rename
from omote.perform.limits import check_known
from omote.perform.scene.scene import Scene
from omote.perform.scene.scene_frame import SceneFrame
from omote.show.cues import cue_edits
from omote.show.cues.cue_book import CueBook, changes_between, edit_cues, find_cue, redo, take_in_list, undo
from omote.show.cues.cue_edits import ON_AIR, LookedAt
from omote.show.declaration import Outgoing
from omote.show.objects import cues as wire
from omote.show.objects.link import Refused
from omote.showfile.changes import DocumentRemoval, StoredDocument

PAUSE_SECONDS = 0.2
"""In which the time of cues comes to a stand, and goes on."""
STEPS_KEPT = 20
"""That Back still undoes after a restart: the journal is written thirty times a second."""

MOST_SENDS = 512
"""That wait to be taken, the newest: a replay takes none."""
MOST_REJECTED = 32

Send = OscSend | MidiSend


@dataclass(frozen=True)
class CuesSnapshot:
    """What a restarted server needs of the cues beside the show file: how far each list is (by name), which is chosen,
    the rate of their time and where it goes, the show mode, and how many GOs were ignored."""

    states: dict[str, CueState] = field(default_factory=dict)
    chosen: str = ""
    rate: float = 1.0
    paused: bool = False
    locked: bool = False
    ignored_count: int = 0


@dataclass(frozen=True)
class RecordedCueStates:
    """What cue lists are beside their cues. states: how far each list is, by name; last_go: when, seconds, monotonic;
    pressed: by list, when somebody pressed last, and who; ignored: the last GO that was not obeyed; rejected: what of
    the last cue was not called; acts: by list, what was pressed."""

    states: Mapping[str, CueState]
    last_go: float
    pressed: Mapping[str, tuple[float, str]]
    ignored: str
    rejected: tuple[str, ...]
    acts: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class RecordedCues:
    """Cues without the log of their edits. cues: of all lists; orders: by list, the identities of its cues; edits: how
    many there were so far; undo, redo: what would be taken back or done again."""

    cues: tuple[Cue, ...]
    orders: Mapping[str, tuple[str, ...]]
    edits: int
    undo: str
    redo: str


class CueLists:
    """The cue lists of a show, each with its player on one scene.

    scene: that of the session, whichever it has now; name_of: what people call a client; edited: called after each
    edit.
    """

    def __init__(
        self, scene: Callable[[], Scene], name_of: Callable[[str], str], edited: Callable[[], None] = lambda: None
    ) -> None:
        self._scene = scene
        self._name_of = name_of
        self._edited = edited
        self.book = CueBook()
        self.chosen = next(iter(self.book.orders))
        self.locked = False
        self._players: dict[str, CuePlayer] = {}
        self._states: dict[str, CueState] = {}
        self._chosen_before = ""
        self._rate = 1.0
        self._recorded_behind: dict[tuple[str, str | None], str] = {}
        self._paused = False
        self._last_go = -math.inf
        self._pressed: dict[str, tuple[float, str]] = {}
        self._acts: dict[str, str] = {}
        self._ignored = ""
        self._ignored_count = 0
        self._rejected: tuple[str, ...] = ()
        self._offers = ("", "")
        self._edits_before = 0
        self.last_edit = ("", "")
        """By whom and what, while `edited` is told of it."""
        self._kept = self.book
        self._lines: list[tuple[str, SpokenLine]] = []
        self._sends: deque[tuple[str, Send]] = deque(maxlen=MOST_SENDS)
        self._play(self.book)

    # --- what is kept ---

    def load(self, book: CueBook) -> None:
        """Plays the lists of a show file, each as far as the snapshot had it. book: what the file keeps."""
        self._kept = book
        self._players = {}
        labels = self._scene().labels
        self._play(replace(book, cues={identity: named_cue(cue, labels) for identity, cue in book.cues.items()}))
        self._states = {}
        if self._chosen_before in book.orders:
            self.chosen = self._chosen_before

    def restore(self, snapshot: CuesSnapshot) -> None:
        """Goes on from a snapshot; the lists, which are loaded later, go on as it has them."""
        self._states = dict(snapshot.states)
        self._chosen_before = snapshot.chosen
        self._rate = snapshot.rate
        self._paused = snapshot.paused
        self.locked = snapshot.locked
        self._ignored_count = snapshot.ignored_count

    def snapshot(self) -> CuesSnapshot:
        """How far each list is."""
        states = {
            name: replace(player.state, steps=player.state.steps[-STEPS_KEPT:], calls=(), done=())
            for name, player in self._players.items()
            if player.cues
        }
        return CuesSnapshot(states, self.chosen, self._rate, self._paused, self.locked, self._ignored_count)

    def playing(self) -> RecordedCueStates:
        """What the lists are beside their cues, for a recording."""
        states = {name: replace(player.state, calls=(), done=()) for name, player in self._players.items()}
        pressed = (dict(self._pressed), self._ignored, self._rejected, dict(self._acts))
        return RecordedCueStates(states, self._last_go, *pressed)

    def shown(self) -> RecordedCues:
        """The cues as they are, for a recording."""
        orders = {name: tuple(order) for name, order in self.book.orders.items()}
        return RecordedCues(tuple(self.book.cues.values()), orders, self.edit_count, *self._offers)

    def replay(self, shown: RecordedCues, playing: RecordedCueStates | None = None) -> None:
        """Plays cues as they were recorded. shown: the cues; playing: what the lists were beside them, None where they
        go on as they are."""
        if playing is not None:
            self._players = {}
        self._edits_before = shown.edits
        self._play(CueBook({cue.identity: cue for cue in shown.cues}, dict(shown.orders)))
        self._offers = (shown.undo, shown.redo)
        if playing is not None:
            self.chosen = self._chosen_before
            for name, state in playing.states.items():
                self._players[name].state = state
            self._last_go = playing.last_go
            self._pressed = dict(playing.pressed)
            self._acts = dict(playing.acts)
            self._ignored = playing.ignored
            self._rejected = playing.rejected

    @property
    def edit_count(self) -> int:
        """How many edits there were."""
        return self._edits_before + len(self.book.edits)

    def take_changes(self) -> list[StoredDocument | DocumentRemoval]:
        """Returns what the show file does not have yet."""
        if self._kept is self.book:
            return []
        changes = changes_between(self._kept, self.book)
        self._kept = self.book
        return changes

    def document(self, name: str) -> wire.CueListDocument | None:
        """A list (name); None where there is none."""
        if name not in self._players:
            return None
        return wire.CueListDocument(self.edit_count, list(self._players[name].cues))

    # --- what plays ---

    def advance(self, dt: float) -> SceneFrame:
        """What is on air some time later, with all that was due called at its own time. dt: seconds."""
        if self._rate != (0.0 if self._paused else 1.0):
            change = dt / PAUSE_SECONDS
            self._set_rate(max(0.0, self._rate - change) if self._paused else min(1.0, self._rate + change))
        frame = advance_lists(self._scene(), [*self._players.values()], dt)
        self._note_played()
        return frame

    def go(self, message: wire.Go, who: str, now: float) -> Sequence[Outgoing]:
        """Calls the cue that stands by, or that of a number. message: asks for it; who: the client; now: seconds."""
        name = self._named(message.cue_list)
        player = self._players[name]
        wanted = find_cue(self.book, name, message.cue) if message.cue else None
        if wanted is not None and player.state.current == wanted.identity:
            return ()  # an OSC sender has no ids: the number is what executes once
        standby = player.standby
        if message.seen and (standby is None or standby.identity != message.seen):
            seen = self.book.cues.get(message.seen)
            stands = f"{standby.number} stands by" if standby else "no cue stands by"
            return self._ignore(who, message.id, "" if seen is None else f" for {seen.number}", stands)
        if self._comes_too_soon(now):
            return self._ignore(who, message.id, "", f"another came less than {GAP_SECONDS:g} s before")
        if self._paused and wanted is None:
            self.pause(on=False)
            return ()
        called = wanted or standby
        if called is None:
            return self._ignore(who, message.id, "", "no cue stands by, for the list is at its end")
        if wanted is None:
            player.go()
        else:
            player.go_to(wanted.number)
        self._note_act(name, who, now, f"GO {called.number}")
        return ()

    def go_back(self, message: wire.GoBack, who: str, now: float) -> Sequence[Outgoing]:
        """Brings back what stood before. message, who, now: as of `go`."""
        name = self._named(message.cue_list)
        if not self._players[name].state.steps:
            raise ValueError("nothing has been called that could be brought back")
        return self._act(name, message, who, now, BACK, self._players[name].go_back)

    def go_to(self, message: wire.GoToCue, who: str, now: float) -> Sequence[Outgoing]:
        """Calls a cue out of its order. message, who, now: as of `go`."""
        name = self._named(message.cue_list)
        cue = find_cue(self.book, name, message.cue)
        player = self._players[name]
        what = f"Go to {cue.number}"
        return self._act(name, message, who, now, what, lambda: player.go_to(cue.number, whole=message.whole))

    def assert_look(self, message: wire.AssertLook, who: str, now: float) -> Sequence[Outgoing]:
        """Calls what the cues have left standing. message, who, now: as of `go`."""
        name = self._named(message.cue_list)
        return self._act(name, message, who, now, ASSERT, self._players[name].assert_look)

    def set_standby(self, message: wire.SetStandby) -> None:
        """Has another cue stand by. message: names it."""
        name = self._named(message.cue_list)
        self._players[name].set_standby(find_cue(self.book, name, message.cue).number)

    def pause(self, *, on: bool) -> None:
        """Pauses the time of the cues, or lets it go on."""
        self._paused = on

    def choose(self, name: str) -> None:
        """Chooses the list that is meant where none is named. name: of the list."""
        self.chosen = check_known(name, self.book.orders, "list of cues")

    # --- what cues do beside ---

    def take_lines(self) -> list[tuple[str, SpokenLine]]:
        """Returns and clears what cues have somebody say, each with the name of its cue."""
        lines = self._lines
        self._lines = []
        return lines

    def take_sends(self) -> list[tuple[str, Send]]:
        """Returns and clears what cues send, each with the name of its cue: a replay takes nothing, and sends
        nothing."""
        sends = [*self._sends]
        self._sends.clear()
        return sends

    def reject(self, sentence: str) -> None:
        """Tells consoles what of a cue could not be done."""
        self._rejected = (*self._rejected, sentence)[-MOST_REJECTED:]

    # --- what edits ---

    def edit(self, message: wire.CueCommand, who: str, scene: Scene, looked_at: LookedAt = ON_AIR) -> LookedAt | None:
        """Makes an edit, and returns the cue that was recorded, as it is looked at then; None of other edits.
        ValueError where it cannot be made, or the show mode is on.

        message: asks for it; who: the client; scene: the one that it looks at; looked_at: the cue there.
        """
        self._check_open()
        by = self._name_of(who)
        if isinstance(message, wire.UndoCues | wire.RedoCues):
            self._check_seen(message.seen)
            self._change((undo if isinstance(message, wire.UndoCues) else redo)(self.book, by))
            return None
        chosen = getattr(message, "cue_list", "") or looked_at.cue_list
        chosen = self._named(chosen, new=isinstance(message, wire.AddCueList))
        state = self._players[chosen].state if chosen in self._players else CueState()
        is_meant = looked_at.cue in self.book.orders.get(chosen, ())
        looked_at = looked_at if is_meant else ON_AIR
        current = looked_at.cue or state.current
        if isinstance(message, wire.RecordCue) and not looked_at.cue:
            current = self._recorded_behind.get((chosen, state.current), current)
        context = cue_edits.EditContext(self.book, scene, chosen, current, by, looked_at)
        before = self.book.cues
        self._change(cue_edits.EDITS[type(message)](context, message))
        if not isinstance(message, wire.RecordCue):
            return None
        (recorded,) = self.book.cues.keys() - before.keys()
        if not looked_at.cue and not message.cue:
            self._recorded_behind = {(chosen, state.current): recorded}
        return LookedAt(chosen, recorded, cue_edits.shown_goals(scene))

    def find(self, name: str, number: str) -> tuple[str, CueList, Cue]:
        """A cue: the list that is meant, its cues, and the one of the number; ValueError where there is none.

        name: of the list, "" for the one that is chosen; number: of the cue.
        """
        name = self._named(name)
        return name, self._players[name].cues, find_cue(self.book, name, number)

    def name_of(self, looked_at: LookedAt) -> wire.CueName | None:
        """The cue that is looked at, as consoles name it; None where none is, or it is gone."""
        return self._cue_name(looked_at.cue or None)

    def take_in(self, name: str, cues: Sequence[Cue], by: str) -> None:
        """Takes in a list as it comes from a text; ValueError where it cannot be, or the show mode is on.

        name: of the list, which may be new; cues: in the order of GO; by: who brings them.
        """
        self._check_open()
        self._change(take_in_list(self.book, name, named_cues(cues, self._scene().labels), by))

    def rename_pad(self, pad: str, to: str, who: str) -> None:
        """Has all cues that move a pad follow it to another name, as one edit, in the show mode too: nothing that they
        play changes. What waits, stands or would come back follows too.

        pad: its name before; to: its name now; who: the client that has renamed it.
        """
        cues = {identity: cue_after_rename(cue, pad, to) for identity, cue in self.book.cues.items()}
        if cues != self.book.cues:
            self._change(edit_cues(self.book, f"rename the pad {pad} to {to}", self._name_of(who), cues, {}))
        for player in self._players.values():
            player.state = state_after_rename(player.state, pad, to)

    def who_moves_pad(self, pad: str) -> list[str]:
        """The cues that move a pad (by its name), in words."""
        named = ((name, cue) for name in self.book.orders for cue in self.book.cues_of(name))
        return [f"the cue {cue.number} of {name}" for name, cue in named if moves_pad(cue, pad)]

    # --- what is told ---

    def status(self, now: float) -> wire.CueStatus | None:
        """What consoles are told; None in a show that never had a cue. now: seconds, monotonic."""
        if not self.edit_count and not self.book.cues:
            return None
        return wire.CueStatus(
            chosen=self.chosen,
            lists={name: self._status_of(name, player, now) for name, player in self._players.items()},
            rate=self._rate,
            edits=self.edit_count,
            undo=self._offers[0],
            redo=self._offers[1],
            ignored=self._ignored,
            ignored_count=self._ignored_count,
            rejected=[*self._rejected],
            locked=self.locked,
        )

    def _status_of(self, name: str, player: CuePlayer, now: float) -> wire.CueListStatus:
        state = player.state
        pressed = self._pressed.get(name)
        following = state.following
        scene = self._scene()
        return wire.CueListStatus(
            current=self._cue_name(state.current),
            standby=self._cue_name(state.standby),
            waits=[
                wire.CueWait(self._number(one.cue), one.part, one.at - state.clock)
                for one in sorted(state.waiting, key=lambda one: one.at)
            ],
            moving=[
                wire.CueMotion(self._number(one.cue), one.part, one.until - state.clock, one.act)
                for one in sorted(state.moving, key=lambda one: one.until)
                if one.part.rpartition("/")[0] in (*scene, "*")
            ],
            follows=None if following is None else self._cue_name(following.cue),
            follows_in=0.0 if following is None else following.at - state.clock,
            since=None if pressed is None else max(0.0, now - pressed[0]),
            by="" if pressed is None else pressed[1],
            pressed=self._acts.get(name, ""),
        )

    def _cue_name(self, identity: str | None) -> wire.CueName | None:
        cue = None if identity is None else self.book.cues.get(identity)
        return None if cue is None else wire.CueName(cue.identity, cue.number, cue.label, cue.note, cue.colour)

    def _number(self, identity: str | None) -> str:
        cue = None if identity is None else self.book.cues.get(identity)
        return "" if cue is None else cue.number

    # --- within ---

    def _set_rate(self, rate: float) -> None:
        """Sets the rate of the time of all lists, and of what they have called. rate: 0 to 1."""
        self._rate = rate
        for player in self._players.values():
            player.pace = rate
        self._scene().set_pace(rate)

    def _named(self, name: str, *, new: bool = False) -> str:
        wanted = name or self.chosen
        return wanted if new else check_known(wanted, self.book.orders, "list of cues")

    def _act(
        self, name: str, message: Any, who: str, now: float, what: str, act: Callable[[], None]
    ) -> Sequence[Outgoing]:  # fmt: skip
        if self._comes_too_soon(now):
            return self._ignore(who, message.id, "", f"another came less than {GAP_SECONDS:g} s before")
        self._paused = False
        act()
        self._note_act(name, who, now, what)
        return ()

    def _comes_too_soon(self, now: float) -> bool:
        return now - self._last_go < GAP_SECONDS

    def _ignore(self, who: str, call: str, what: str, why: str) -> Sequence[Outgoing]:
        """Tells all consoles that a GO was not obeyed; its id counts as executed, so no retry of it calls anything."""
        self._ignored = f"GO{what} of {self._name_of(who)} ignored: {why}."
        self._ignored_count += 1
        return (Outgoing(who, Refused(f"ignored: {why}. Nothing was called.", call)),)

    def _note_act(self, name: str, who: str, now: float, what: str) -> None:
        self._last_go = now
        self._acts[name] = what
        self._pressed[name] = (now, self._name_of(who))
        self._rejected = ()
        self._note_played()

    def _note_played(self) -> None:
        """Takes what the last act or step has sent and said, and what it could not call."""
        rejected = tuple(said for player in self._players.values() for said in player.rejected)
        if rejected:
            self._rejected = rejected
        for player in self._players.values():
            for cue, action in player.take_actions():
                meant = action.meant
                if isinstance(meant, SpokenLine):
                    self._lines.append((cue, meant))
                else:
                    self._sends.append((cue, meant))

    def _check_open(self) -> None:
        if self.locked:
            raise ValueError("the show mode is on, so no cue is edited; whoever runs the show switches it off")

    def _check_seen(self, seen: int | None) -> None:
        if seen is not None and seen != len(self.book.edits):
            last = self.book.edits[-1] if self.book.edits else None
            who = "" if last is None else f": {last.by} has done since: {last.what}"
            raise ValueError(f"the cues have been edited since you pressed{who}")

    def _change(self, book: CueBook) -> None:
        """Plays the lists as an edit has left them."""
        if len(book.edits) > len(self.book.edits):
            edit = book.edits[-1]
            self.last_edit = (edit.by, edit.what if edit.does == "edit" else f"{edit.does}: {edit.what}")
        self._play(book)
        self.last_edit = ("", "")

    def _play(self, book: CueBook) -> None:
        """Plays the lists as they are in a book; what is on its way goes on."""
        self.book = book
        players: dict[str, CuePlayer] = {}
        for name in book.orders:
            cues = book.cues_of(name)
            player = self._players.get(name) or self._renamed(name, cues)
            if player.cues != cues:
                player.edit(cues)
            players[name] = player
        self._players = players
        if self.chosen not in players:
            self.chosen = next(iter(players))
        done, back = book.undone
        self._offers = (book.edits[done[-1]].what if done else "", book.edits[back[-1]].what if back else "")
        self._edited()

    def _renamed(self, name: str, cues: tuple[Cue, ...]) -> CuePlayer:
        """The player of a list that has come: it goes on as the one that had its cues before, or as a snapshot has
        it."""
        player = CuePlayer(self._scene(), cues)
        before = next((other for other in self._players.values() if cues and other.cues == cues), None)
        state = before.state if before is not None else self._states.get(name)
        player.pace = self._rate
        if state is not None:
            standing = edited(state, cues, cues)
            ended = before is None and state.standby is None  # what a snapshot has at its end stays there
            player.state = replace(standing, standby=None) if ended else standing
        return player
