"""Authoring without input or output: bytes of editors and work done in, orders, changes and answers out.

The server commits an outcome's changes before it sends its replies, so whatever was acknowledged is kept.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field

from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import checked_label
from omote.edit.protocol.orders import Baked, EditOrder
from omote.edit.protocol.validation import Bounds
from omote.edit.protocol.wire import decode, decode_baked, read_recipe, write_recipe
from omote.edit.session import drafts, items, saving
from omote.edit.session.draft_queue import Lanes, Task
from omote.edit.session.plan import Authored, Kept, Plan, Result
from omote.edit.session.requests import Asked, lane
from omote.edit.session.requests import answer as respond
from omote.edit.session.saving import Hand
from omote.edit.store.authored_state import DraftKey, Ledger
from omote.edit.store.content_store import Shelf
from omote.edit.store.on_air_recipes import OnAir, recipe_on_air
from omote.edit.store.sources import Sources
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY
from omote.show.messages import Message
from omote.show.validation import Refusal
from omote.showfile.changes import Change, Kind, Stored
from omote.stage_data.playing_cast import Own, digest_of


@dataclass(frozen=True)
class Outgoing:
    """A message for one editor."""

    who: str
    message: wire.ToEditor


@dataclass(frozen=True)
class Outcome:
    """What the server does now, in this order: gives the workshop the orders, commits the changes (together), loads
    the cast anew where `cast`, sends the replies and tells consoles what was kept."""

    orders: tuple[tuple[int, EditOrder], ...] = ()
    changes: tuple[Change, ...] = ()
    replies: tuple[Outgoing, ...] = ()
    cast: bool = False
    kept: tuple[Kept, ...] = ()


@dataclass(frozen=True)
class Member:
    """A page that greeted: its editor's id and name, and the items it has open."""

    editor: str
    name: str
    open: dict[int, None]


@dataclass
class _Answer:
    """An outcome while it is being made."""

    orders: list[tuple[int, EditOrder]] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    replies: list[Outgoing] = field(default_factory=list)
    kept: list[Kept] = field(default_factory=list)
    greeted: str | None = None
    listed: bool = False


class EditSession:
    """Who is editing what, and everything authored.

    contents: what the show file has, by key; net: the control points of a new expression; welcome: what does not
    change of the answer to greet.
    """

    def __init__(
        self,
        base: Cast,
        stored: Stored,
        contents: Mapping[str, bytes],
        *,
        net: tuple[int, ...],
        welcome: wire.Greeted,
    ) -> None:
        ledger, shelf = Ledger(stored), Shelf(contents)
        for revision in stored.revisions:
            with suppress(Refusal):  # what one recipe spoils, the others need not suffer
                shelf.know(write_recipe(read_recipe(revision.recipe)), revision.content)
        bounds = Bounds(base.space.on_sheet, frozenset(muscle.name for muscle in welcome.muscles))
        self.authored = Authored(base, ledger, shelf, Sources(base, ledger, shelf), bounds, net)
        self._welcome = welcome
        self.refused = 0
        self.crew: dict[str, Member] = {}
        self._lanes = Lanes()
        self._digest = digest_of(base.digest, self.own())
        self._told = items.listing(ledger, self._digest, self._editors)

    @property
    def contents(self) -> Mapping[str, bytes]:
        """The bytes of everything that can be shown, by key: kept or not."""
        return self.authored.shelf

    @property
    def digest(self) -> str:
        """The name of the cast as it plays now, own things and all."""
        return self._digest

    def own(self) -> tuple[Own, ...]:
        """The own faces and expressions that play."""
        return items.own_things(self.authored.ledger)

    def stored(self) -> Stored:
        """All authored work."""
        return self.authored.ledger.stored()

    def hear(self, who: str, data: bytes, *, wall: float, on_air: OnAir) -> Outcome:
        """What follows from the bytes of an editor; wall: seconds since 1970, for people to read only."""
        answer, request = _Answer(), -1
        try:
            message = decode(data)
            if isinstance(message, wire.Greet):
                self._greet(answer, who, message)
            else:
                request = message.request
                self._do(answer, self._task(who, message, wall, on_air))
        except Refusal as refusal:
            self._refuse(answer, who, request, refusal)
        return self._outcome(answer)

    def made(self, order: int, result: bytes | str | None) -> Outcome:
        """What follows from an order: the workshop's answer, or why there is none (a sentence, or None)."""
        answer, landed = _Answer(), self._lanes.land(order)
        if landed is not None:
            task, plan = landed
            try:
                self._carry_out(answer, task, plan.finish(self._taken(plan, result)))
            except Refusal as refusal:
                self._fail(answer, task, refusal)
            self._go_on(answer, task)
        return self._outcome(answer)

    def leave(self, who: str) -> Outcome:
        """An editor's page is gone; its drafts stay, and what it asked for is still carried out."""
        self.crew.pop(who, None)
        return self._outcome(_Answer(listed=True))

    def keep(
        self, kind: Kind, on_air: OnAir, *, label: str | None, wall: float, editor: str, ticket: str = ""
    ) -> Outcome:
        """What is on air as a new item; `Outcome.kept` says what became of it, now or after an order."""
        authored, answer, hand = self.authored, _Answer(), Hand(editor, "", wall)
        try:
            recipe = recipe_on_air(kind, on_air, authored.net, authored.sources)
            plan = saving.keep(authored, kind, label, recipe, hand, ticket)
            self._do(answer, Task((0, ""), lambda: plan, ticket=ticket))
        except Refusal as refusal:
            answer.kept.append(Kept(ticket, trouble=str(refusal)))
        return self._outcome(answer)

    # --- hearing ------------------------------------------------------------------------------------------------------

    def _greet(self, answer: _Answer, who: str, greet: wire.Greet) -> None:
        if greet.version != wire.EDITING_VERSION:
            versions = f"version {greet.version}, the server {wire.EDITING_VERSION}"
            raise Refusal(f"the page speaks {versions}: reload the page.")
        self.crew[who] = Member(greet.editor, checked_label(greet.name, "your name"), {})
        answer.greeted, answer.listed = who, True

    def _task(self, who: str, message: Message, wall: float, on_air: OnAir) -> Task:
        member = self.crew.get(who)
        if member is None:
            raise Refusal("nothing is heard before greet: send greet with editor, name and version first.")
        asked = Asked(self.authored, message, Hand(member.name, member.editor, wall), on_air)
        request: int = asked.message.request
        return Task(lane(message, member.editor), lambda: respond(asked), who, request)

    # --- carrying out -------------------------------------------------------------------------------------------------

    def _do(self, answer: _Answer, task: Task) -> None:
        if self._lanes.enter(task):
            self._begin(answer, task)

    def _begin(self, answer: _Answer, task: Task) -> bool:
        """Whether the task is over at once; else it waits for an order."""
        try:
            plan = task.begin()
            if isinstance(plan, Plan):
                known = self.authored.shelf.recall(plan.order)
                if known is None:
                    answer.orders.append(self._lanes.order(task, plan))
                    return False
                plan = plan.finish(known)
            self._carry_out(answer, task, plan)
        except Refusal as refusal:
            self._fail(answer, task, refusal)
        return True

    def _go_on(self, answer: _Answer, task: Task) -> None:
        following = self._lanes.following(task)
        while following is not None and self._begin(answer, following):
            following = self._lanes.following(following)

    def _taken(self, plan: Plan, result: bytes | str | None) -> Baked:
        """The workshop's answer, its contents remembered; Refusal where there is none."""
        if not isinstance(result, bytes):
            raise Refusal(result or "the workshop gave no answer: try again.")
        baked, shelf = decode_baked(result), self.authored.shelf
        if baked.key not in baked.contents and baked.key not in shelf:
            raise Refusal("the workshop's answer is without its content: try again.")
        shelf.take(plan.order, baked)
        return baked

    def _carry_out(self, answer: _Answer, task: Task, result: Result) -> None:
        self.authored.ledger.apply(result.changes)
        answer.changes += result.changes
        answer.listed |= result.lists
        member = self.crew.get(task.who)
        if member is not None and result.opened is not None:
            member.open[result.opened] = None
        if member is not None and result.closed is not None:
            member.open.pop(result.closed, None)
        if result.reply is not None:
            answer.replies.append(Outgoing(task.who, result.reply))
        if result.kept is not None:
            answer.kept.append(result.kept)
        if result.draft is not None:
            self._show(answer, task, result, result.draft)

    # --- answering ----------------------------------------------------------------------------------------------------

    def _show(self, answer: _Answer, task: Task, result: Result, key: DraftKey) -> None:
        """The draft's state to whoever asked, and to the editor's other windows where it changed."""
        state = self._state(key, whole=result.whole, miss=result.miss)
        request = task.request if result.reply is None else -1
        answer.replies.append(Outgoing(task.who, replace(state, request=request)))
        for who, member in self.crew.items():
            if who != task.who and member.editor == key[1] and key[0] in member.open and result.changes:
                answer.replies.append(Outgoing(who, state))

    def _state(self, key: DraftKey, *, whole: bool, miss: float) -> wire.DraftState:
        ledger, shelf = self.authored.ledger, self.authored.shelf
        draft, shown = ledger.drafts[key], ledger.shown(key)
        recipe = read_recipe(shown.recipe)
        return wire.DraftState(
            request=-1,
            item=key[0],
            recipe=recipe,
            content=KEY + shelf.key(shown.recipe),
            undo=draft.cursor,
            redo=len(ledger.edits[key]) - 1 - draft.cursor,
            base=draft.base,
            dirty=drafts.is_dirty(ledger, key),
            what=shown.what,
            net=shelf.net(recipe) if whole else None,
            miss=miss,
            others=self._editors(key[0], but=key[1]),
        )

    def _editors(self, item: int, *, but: str = "") -> list[str]:
        """Names of those who have an item open, each editor once."""
        names = {m.editor: m.name for m in self.crew.values() if item in m.open and m.editor != but}
        return list(names.values())

    def _fail(self, answer: _Answer, task: Task, refusal: Refusal) -> None:
        if task.ticket is None:
            self._refuse(answer, task.who, task.request, refusal)
        else:
            answer.kept.append(Kept(task.ticket, trouble=str(refusal)))

    def _refuse(self, answer: _Answer, who: str, request: int, refusal: Refusal) -> None:
        self.refused += 1
        answer.replies.append(Outgoing(who, wire.EditRefused(request, str(refusal))))

    def _outcome(self, answer: _Answer) -> Outcome:
        """The outcome, and the list of all items to everybody where it has changed."""
        before = self._digest
        if answer.listed:
            self._digest = digest_of(self.authored.base.digest, self.own())
        listed = items.listing(self.authored.ledger, self._digest, self._editors) if answer.listed else self._told
        if answer.greeted is not None:
            welcome = replace(self._welcome, version=wire.EDITING_VERSION, digest=self._digest, items=listed.items)
            answer.replies.append(Outgoing(answer.greeted, welcome))
        if listed != self._told:
            answer.replies += [Outgoing(who, listed) for who in self.crew if who != answer.greeted]
            self._told = listed
        replies = tuple(
            each for each in answer.replies if each.who in self.crew or isinstance(each.message, wire.EditRefused)
        )
        return Outcome(tuple(answer.orders), tuple(answer.changes), replies, self._digest != before, tuple(answer.kept))
