"""A test harness of the edit session without server or computation: instant answers, plain tables for the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import msgspec
import numpy as np

from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import Bake, Baked, EditOrder, Flat, Renet, Solve
from omote.edit.protocol.validation import FEWEST_POINTS
from omote.edit.protocol.wire import encode, write_recipe
from omote.edit.session.console_requests import keep_on_air
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.store.on_air_recipes import OnAir
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, AnyRecipe, Recipe, sources
from omote.model.space.head_regions import REGIONS
from omote.show.declaration import Message
from omote.showfile.changes import (
    Change,
    Content,
    ContentRemoval,
    DocumentRemoval,
    Documents,
    Draft,
    Edit,
    Item,
    Kind,
    Revision,
    Stored,
    StoredDocument,
    content_key,
)

MUSCLES = ("smiler", "frowner")
WALL = 1.75e9
POINTS = 5


def net_of(cast: Cast, count: int = POINTS) -> tuple[int, ...]:
    """As many vertices of the sheet, from its first on."""
    assert count >= FEWEST_POINTS
    return tuple(int(row) for row in np.flatnonzero(cast.space.on_sheet)[:count])


def welcome() -> wire.Greeted:
    """An answer to greet with two muscles and no pictures."""
    muscles = [wire.MuscleDocument(name, name.title(), "linear", [0, 1], b"") for name in MUSCLES]
    return wire.Greeted(0, "", "", muscles, list(REGIONS), b"", b"", b"", b"", [], [], {})


def net_document(net: tuple[int, ...]) -> wire.NetDocument:
    """A document that names its net and says nothing else."""
    return wire.NetDocument(list(net), b"", b"", b"", [-1] * len(net))


def make_baked(order: EditOrder) -> Baked:
    """What the workshop would answer, with bytes that only name what they were made from.

    Raises AssertionError where the order lacks a content that its recipe names.
    """
    named = {source.removeprefix(KEY) for source in sources(order.recipe) if source.startswith(KEY)}
    assert named <= order.contents.keys(), "an order carries all that it needs"
    made: dict[str, bytes] = {}
    recipe: AnyRecipe = order.recipe
    net = None
    miss = 0.0
    match order:
        case Solve():
            vectors = list(order.vectors)
            for place, (x, y, _) in zip(order.points, order.targets, strict=True):
                vectors[place] = (x, y, 1.0)
            recipe = msgspec.structs.replace(order.recipe, vectors=tuple(vectors))
            miss = 1e-6
        case Renet():
            vectors = [(0.0, 0.0, 1.0)] * len(order.net)
            recipe = msgspec.structs.replace(order.recipe, net=order.net, vectors=tuple(vectors))
            net = net_document(order.net)
        case Flat():
            ground = b"ground of " + write_recipe(order.recipe)
            made[content_key(ground)] = ground
            rest = ((0.0, 0.0, 1.0),) * len(order.recipe.net)
            recipe = Recipe(order.recipe.net, rest, ground=KEY + content_key(ground))
        case Bake():
            net = net_document(order.recipe.net) if order.with_net and isinstance(order.recipe, Recipe) else None
    data = b"made of " + write_recipe(recipe)
    return Baked(recipe, content_key(data), made | {content_key(data): data}, net, miss)


@dataclass
class Tables:
    """A show file in memory: what `omote.showfile` keeps, by the words of `showfile.changes` alone."""

    items: dict[int, Item] = field(default_factory=dict)
    revisions: dict[tuple[int, int], Revision] = field(default_factory=dict)
    drafts: dict[tuple[int, str], Draft] = field(default_factory=dict)
    edits: dict[tuple[int, str, int], Edit] = field(default_factory=dict)
    documents: dict[tuple[str, str], bytes] = field(default_factory=dict)
    contents: dict[str, bytes] = field(default_factory=dict)

    def apply(self, changes: Iterable[Change]) -> None:
        """Commits changes."""
        for change in changes:
            match change:
                case Content(key, data):
                    assert self.contents.setdefault(key, data) == data
                case ContentRemoval(key):
                    self.contents.pop(key, None)
                case StoredDocument(kind, name, body):
                    self.documents[kind, name] = body
                case DocumentRemoval(kind, name):
                    self.documents.pop((kind, name), None)
                case _:
                    self._put(change)

    def _put(self, row: Item | Revision | Draft | Edit) -> None:
        match row:
            case Item():
                self.items[row.id] = row
            case Revision():
                assert (row.item, row.number) not in self.revisions, "revisions are never replaced"
                self.revisions[row.item, row.number] = row
            case Draft():
                self.drafts[row.item, row.editor] = row
            case Edit():
                draft = row.item, row.editor
                left = {key: edit for key, edit in self.edits.items() if key[:2] != draft or key[2] < row.number}
                self.edits = left | {(*draft, row.number): row}

    def stored(self) -> Stored:
        """Everything but the contents, in the order of keys."""
        documents: Documents = {}
        for (kind, name), body in self.documents.items():
            documents.setdefault(kind, {})[name] = body
        return Stored(
            tuple(self.items[key] for key in sorted(self.items)),
            tuple(self.revisions[key] for key in sorted(self.revisions)),
            tuple(self.drafts[key] for key in sorted(self.drafts)),
            tuple(self.edits[key] for key in sorted(self.edits)),
            documents,
        )


class EditHarness:
    """An edit session with a fake worker and file: every order is carried out at once, unless `slow`."""

    def __init__(self, cast: Cast, tables: Any = None, *, slow: bool = False) -> None:
        self.cast = cast
        self.slow = slow
        self.tables = Tables() if tables is None else tables
        self.on_air = OnAir(faces={"generic": 1.0}, expressions={"neutral": 1.0})
        self.wall = WALL
        self.make_baked: Callable[[EditOrder], Baked | str | None] = make_baked
        self.orders: list[tuple[int, EditOrder]] = []
        self.ordered: list[EditOrder] = []
        self.outcomes: list[Outcome] = []
        self.start()

    def start(self) -> None:
        """The session of a server that starts, from what was committed."""
        self.orders.clear()
        contents: Mapping[str, bytes] = dict(self.tables.contents)
        self.session = EditSession(
            self.cast, self.tables.stored(), contents, net=net_of(self.cast), welcome=welcome()
        )  # fmt: skip
        self._request = 0

    def greet(self, who: str, editor: str | None = None, name: str | None = None) -> wire.Greeted:
        """A page that opens its link."""
        (answer,) = self.say(who, wire.Greet(editor or who, name or who.title(), wire.EDITING_VERSION), wire.Greeted)
        assert isinstance(answer, wire.Greeted)
        return answer

    def ask(self, who: str, request: Callable[..., Message], *arguments: Any) -> Any:
        """The answer to a request, under a number of its own."""
        self._request += 1
        self.wall += 1.0
        answers = self.say(who, request(self._request, *arguments))
        found = [each for each in answers if getattr(each, "request", None) == self._request]
        assert len(found) == 1, f"one answer to each request, but there are {found}"
        return found[0]

    def say(self, who: str, message: Message, kind: type = object) -> list[Any]:
        """Everything of a kind that goes back to whoever speaks."""
        told = self.receive_bytes(who, encode(message))  # type: ignore[arg-type]
        return [each for to, each in told if to == who and isinstance(each, kind)]

    def receive_bytes(self, who: str, data: bytes) -> list[tuple[str, Any]]:
        """Everything that goes to anybody after these bytes, once all orders are done."""
        return self.carry_out(self.session.receive_bytes(who, data, wall=self.wall, on_air=lambda: self.on_air))

    def carry_out(self, outcome: Outcome) -> list[tuple[str, Any]]:
        """Commits an outcome, does its orders (or, `slow`, lays them aside) and gives all messages."""
        told: list[tuple[str, Any]] = []
        outcomes = [outcome]
        while outcomes:
            outcome = outcomes.pop(0)
            self.outcomes.append(outcome)
            self.tables.apply(outcome.changes)
            told += [(each.who, each.message) for each in outcome.replies]
            self.orders += outcome.orders
            self.ordered += [order for _, order in outcome.orders]
            while self.orders and not self.slow:
                outcomes.append(self.answer(*self.orders.pop(0)))
        return told

    def answer(self, number: int, order: EditOrder) -> Outcome:
        """The outcome of one order."""
        baked = self.make_baked(order)
        return self.session.finish_order(number, encode(baked) if isinstance(baked, Baked) else baked)

    def keep(self, kind: Kind, label: str | None = None, ticket: str = "ticket") -> Any:
        """One press of "save what is on air", and what became of it."""
        before = len(self.outcomes)
        self.carry_out(
            keep_on_air(self.session, kind, self.on_air, label=label, wall=self.wall, editor="console", ticket=ticket)
        )  # fmt: skip
        (kept,) = [kept for outcome in self.outcomes[before:] for kept in outcome.kept]
        return kept
