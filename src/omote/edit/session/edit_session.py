"""The edit session without input or output: editors' bytes and finished orders in; orders, changes and answers out.

The server commits an outcome's changes before it sends its replies, so whatever was acknowledged is stored.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field

from msgspec.structs import replace

from omote.edit.protocol import messages as wire
from omote.edit.protocol.names import clean_label
from omote.edit.protocol.orders import Baked, EditOrder
from omote.edit.protocol.validation import Bounds
from omote.edit.protocol.wire import decode, decode_baked, read_recipe, request_in, write_recipe
from omote.edit.session import drafts, items
from omote.edit.session.draft_queue import DraftQueues, Task
from omote.edit.session.plan import Authored, KeepOutcome, Plan, Result
from omote.edit.session.requests import RequestContext, queue_key
from omote.edit.session.requests import answer as respond
from omote.edit.session.saving import Author
from omote.edit.store.authored_state import AuthoredState, DraftKey
from omote.edit.store.content_store import ContentStore
from omote.edit.store.on_air_recipes import OnAir
from omote.edit.store.sources import SourceResolver
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY
from omote.show.access.people_list import ANYBODY, Visitor
from omote.show.declaration import Message
from omote.show.objects.link import Cancel
from omote.show.validation import Refusal
from omote.showfile.changes import Change, Stored
from omote.stage_data.playing_cast import Own, digest_of


@dataclass(frozen=True)
class EditorReply:
    """A message for one editor."""

    who: str
    message: wire.ToEditor


@dataclass(frozen=True)
class Outcome:
    """What the server must do now, in order: send the orders to the workshop, commit the changes (together), reload the
    cast where `cast`, send the replies, tell consoles what was kept, and end the long requests that are cancelled."""

    orders: tuple[tuple[int, EditOrder], ...] = ()
    changes: tuple[Change, ...] = ()
    replies: tuple[EditorReply, ...] = ()
    cast: bool = False
    kept: tuple[KeepOutcome, ...] = ()
    cancelled: tuple[str, ...] = ()


@dataclass(frozen=True)
class EditorMember:
    """A connected editor page: its editor's id and name, and the items that it has open."""

    editor: str
    name: str
    open: dict[int, None]


@dataclass
class _Answer:
    """An outcome while it is being made."""

    orders: list[tuple[int, EditOrder]] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    replies: list[EditorReply] = field(default_factory=list)
    kept: list[KeepOutcome] = field(default_factory=list)
    cancelled: list[str] = field(default_factory=list)
    greeted: str | None = None
    listed: bool = False


class EditSession:
    """All authored work, and who is editing what.

    contents: what the show file has, by key; net: the control points of a new expression; welcome: the constant part of
    the answer to greet; show: which show this is, "" where no file says so.
    """

    def __init__(
        self, base: Cast, stored: Stored, contents: Mapping[str, bytes], *, net: tuple[int, ...], welcome: wire.Greeted
    ) -> None:
        state = AuthoredState(stored)
        store = ContentStore(contents)
        for revision in stored.revisions:
            with suppress(Refusal):  # one unreadable recipe does not affect the others
                store.remember_recipe(write_recipe(read_recipe(revision.recipe)), revision.content)
        muscles = frozenset(muscle.name for muscle in welcome.muscles)
        bounds = Bounds(base.space.on_sheet, muscles, frozenset(base.hair))
        self.authored = Authored(base, state, store, SourceResolver(base, state, store), bounds, net)
        self._welcome = welcome
        self.show = ""
        self.refused = 0
        self.crew: dict[str, EditorMember] = {}
        self._queues = DraftQueues()
        self._digest = digest_of(base.digest, self.own())
        self._sent = items.list_items(state, self._digest, self._editors)

    @property
    def contents(self) -> Mapping[str, bytes]:
        """The bytes of all contents that can be shown, by key, stored or not."""
        return self.authored.store

    @property
    def digest(self) -> str:
        """The digest of the cast as it plays now, authored items included."""
        return self._digest

    def own(self) -> tuple[Own, ...]:
        """The authored faces and expressions that play."""
        return items.own_things(self.authored.state)

    def stored(self) -> Stored:
        """All authored work."""
        return self.authored.state.stored()

    def receive_bytes(
        self, who: str, data: bytes, wall: float, on_air: Callable[[], OnAir], visitor: Visitor = ANYBODY
    ) -> Outcome:
        """Handles the bytes of an editor; wall: seconds since 1970, shown in histories; visitor: who sends them, whose
        token gives them their name.

        who: the link; data: a message; on_air: tells what shows now; asked for requests alone.
        """
        answer = _Answer()
        try:
            message = decode(data, visitor.role)
            if isinstance(message, wire.Greet):
                self._greet(answer, who, message, visitor.name)
            elif isinstance(message, Cancel):
                answer.cancelled.append(message.request)
            else:
                self._start(answer, self._task(who, message, wall, on_air))
        except Refusal as refusal:
            self._refuse(answer, who, request_in(data), refusal)
        return self._outcome(answer)

    def finish_order(self, order: int, result: bytes | str | None) -> Outcome:
        """Handles a finished order: the workshop's answer, or why there is none (a sentence, or None).

        order: its number; result: the bytes of `Baked`.
        """
        answer = _Answer()
        finished = self._queues.finish_order(order)
        if finished is not None:
            task, plan = finished
            try:
                self._carry_out(answer, task, plan.finish(self._read_result(plan, result)))
            except Refusal as refusal:
                self._fail(answer, task, refusal)
            self._run_waiting(answer, task)
        return self._outcome(answer)

    def leave(self, who: str) -> Outcome:
        """Removes an editor's page; its drafts stay, and its pending requests are still carried out."""
        self.crew.pop(who, None)
        return self._outcome(_Answer(listed=True))

    def carry_out(self, begin: Callable[[], Plan | Result], ticket: str, queue: DraftKey | None = None) -> Outcome:
        """Carries out what a console asks, after what waits in the queue; `Outcome.kept` tells of it by the ticket.

        begin: does it, or plans it; ticket: the asker's; queue: None for at once.
        """
        answer = _Answer()
        task = Task(queue, begin, ticket=ticket)
        try:
            self._start(answer, task)
        except Refusal as refusal:
            self._fail(answer, task, refusal)
        return self._outcome(answer)

    # --- receiving ----------------------------------------------------------------------------------------------------

    def _greet(self, answer: _Answer, who: str, greet: wire.Greet, name: str) -> None:
        if greet.version != wire.EDITING_VERSION:
            versions = f"version {greet.version}, the server {wire.EDITING_VERSION}"
            raise Refusal(f"the page speaks {versions}: reload the page.")
        self.crew[who] = EditorMember(greet.editor, clean_label(name or greet.name, "your name"), {})
        answer.greeted = who
        answer.listed = True

    def _task(self, who: str, message: Message, wall: float, on_air: Callable[[], OnAir]) -> Task:
        member = self.crew.get(who)
        if member is None:
            raise Refusal("nothing is heard before greet: send greet with editor, name and version first.")
        context = RequestContext(self.authored, message, Author(member.name, member.editor, wall), on_air())
        return Task(queue_key(message, member.editor), lambda: respond(context), who, context.message.request)

    # --- carrying out -------------------------------------------------------------------------------------------------

    def _start(self, answer: _Answer, task: Task) -> None:
        if self._queues.try_start(task):
            self._begin(answer, task)

    def _begin(self, answer: _Answer, task: Task) -> bool:
        """Begins a task; whether it finished at once, else it waits for an order."""
        try:
            plan = task.begin()
            if isinstance(plan, Plan):
                recalled = self.authored.store.recall(plan.order)
                if recalled is None:
                    answer.orders.append(self._queues.start_order(task, plan))
                    return False
                plan = plan.finish(recalled)
            self._carry_out(answer, task, plan)
        except Refusal as refusal:
            self._fail(answer, task, refusal)
        return True

    def _run_waiting(self, answer: _Answer, task: Task) -> None:
        following = self._queues.next_task(task)
        while following is not None and self._begin(answer, following):
            following = self._queues.next_task(following)

    def _read_result(self, plan: Plan, result: bytes | str | None) -> Baked:
        """Decodes the workshop's answer and stores its contents; Refusal where there is none."""
        if not isinstance(result, bytes):
            raise Refusal(result or "the workshop gave no answer: try again.")
        baked = decode_baked(result)
        store = self.authored.store
        if baked.key not in baked.contents and baked.key not in store:
            raise Refusal("the workshop's answer is without its content: try again.")
        store.remember_result(plan.order, baked)
        return baked

    def _carry_out(self, answer: _Answer, task: Task, result: Result) -> None:
        self.authored.state.apply(result.changes)
        answer.changes += result.changes
        answer.listed |= result.lists
        member = self.crew.get(task.who)
        if member is not None and result.opened is not None:
            member.open[result.opened] = None
        if member is not None and result.closed is not None:
            member.open.pop(result.closed, None)
        if result.reply is not None:
            answer.replies.append(EditorReply(task.who, result.reply))
        if result.kept is not None:
            answer.kept.append(result.kept)
        if result.draft is not None:
            self._show(answer, task, result, result.draft)

    # --- answering ----------------------------------------------------------------------------------------------------

    def _show(self, answer: _Answer, task: Task, result: Result, key: DraftKey) -> None:
        """Sends the draft's state to the asker, and to the editor's other windows where it changed."""
        state = self._state(key, whole=result.whole, miss=result.miss)
        request = task.request if result.reply is None else -1
        answer.replies.append(EditorReply(task.who, replace(state, request=request)))
        for who, member in self.crew.items():
            if who != task.who and member.editor == key[1] and key[0] in member.open and result.changes:
                answer.replies.append(EditorReply(who, state))

    def _state(self, key: DraftKey, *, whole: bool, miss: float) -> wire.DraftState:
        state = self.authored.state
        store = self.authored.store
        draft = state.drafts[key]
        shown = state.shown_edit(key)
        recipe = read_recipe(shown.recipe)
        return wire.DraftState(
            request=-1,
            item=key[0],
            recipe=recipe,
            content=KEY + store.key(shown.recipe),
            undo=draft.cursor,
            redo=len(state.edits[key]) - 1 - draft.cursor,
            base=draft.base,
            dirty=drafts.is_dirty(state, key),
            what=shown.what,
            net=store.net(recipe) if whole else None,
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
            answer.kept.append(KeepOutcome(task.ticket, trouble=str(refusal)))

    def _refuse(self, answer: _Answer, who: str, request: int, refusal: Refusal) -> None:
        self.refused += 1
        answer.replies.append(EditorReply(who, wire.EditRefused(request, str(refusal))))

    def _outcome(self, answer: _Answer) -> Outcome:
        """Completes the outcome: adds the list of all items for every editor where it has changed."""
        before = self._digest
        if answer.listed:
            self._digest = digest_of(self.authored.base.digest, self.own())
        listed = items.list_items(self.authored.state, self._digest, self._editors) if answer.listed else self._sent
        if answer.greeted is not None:
            unsaved = drafts.find_unsaved(self.authored.state, self.crew[answer.greeted].editor)
            welcome = replace(self._welcome, version=wire.EDITING_VERSION, digest=self._digest, show=self.show)
            answer.replies.append(EditorReply(answer.greeted, replace(welcome, items=listed.items, unsaved=unsaved)))
        if listed != self._sent:
            answer.replies += [EditorReply(who, listed) for who in self.crew if who != answer.greeted]
            self._sent = listed
        replies = tuple(
            reply for reply in answer.replies if reply.who in self.crew or isinstance(reply.message, wire.EditRefused)
        )
        changes = tuple(answer.changes)
        cast = self._digest != before
        return Outcome(tuple(answer.orders), changes, replies, cast, tuple(answer.kept), tuple(answer.cancelled))
