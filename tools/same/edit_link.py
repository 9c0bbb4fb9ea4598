"""Records an editors' link: what a seeded script of several pages is answered with, every change, and the show file."""

from __future__ import annotations

import sqlite3
import tempfile
from collections.abc import Iterable
from contextlib import closing
from dataclasses import dataclass, field
from pathlib import Path

import msgspec
import numpy as np

from omote.builtin import load_cast
from omote.edit.compute.order_runner import OrderRunner
from omote.edit.compute.welcome import build_welcome
from omote.edit.protocol import messages as wire
from omote.edit.protocol.orders import EditOrder
from omote.edit.protocol.wire import encode
from omote.edit.session.console_requests import keep_on_air
from omote.edit.session.edit_session import EditSession, Outcome
from omote.edit.store.import_items import (
    ImportedItem,
    changes_to_import,
    export_document,
    import_document,
    make_document,
)
from omote.edit.store.on_air_recipes import OnAir
from omote.interchange.formats.expression_json import encode as expression_bytes
from omote.model.cast import Cast
from omote.model.controls.default_net import default_net
from omote.model.recipes.recipe import Recipe
from omote.showfile.changes import StoredDocument
from omote.showfile.inspection import verdicts
from omote.showfile.show_file import ShowFile, open_show
from omote.stage_data.playing_cast import build_playing_cast
from tools.same.compounds import SEED
from tools.same.edit_script import Script
from tools.same.recording import Recording

WALL = 1.75e9
STEPS = 450
PAGES = {"ann": "ann", "ann's other window": "ann", "bob": "bob", "stranger": "eve"}
BROKEN = (b"", b"\xff" * 100, b"\x00" * 65537, b"\x80", b"\x81\xa4type\xa5dance", b"\x81\xa4type\xa5greet")
LATE = 0.25
LOST = 0.04
"""How often an order waits for a while, and how often nothing, or nonsense, comes of it."""


@dataclass
class House:
    """A session with its show file, whoever makes its orders, and what is recorded of it."""

    recording: Recording
    cast: Cast
    file: ShowFile
    script: Script
    craft: OrderRunner
    session: EditSession
    waiting: list[tuple[int, EditOrder]] = field(default_factory=list)
    outcomes: int = 0

    def ask(self, key: str, who: str, data: bytes, on_air: OnAir) -> None:
        """What follows from a page's bytes, orders and all; some orders wait."""
        self.recording.data("editing: sent by the script", key, data)
        self.settle(key, self.session.receive_bytes(who, data, wall=WALL + self.script.number, on_air=lambda: on_air))

    def settle(self, key: str, outcome: Outcome) -> None:
        """Commits what an outcome changes, records it, and makes what it orders."""
        self._record(key, outcome)
        self.file.apply(outcome.changes)
        for number, order in outcome.orders:
            self.waiting.append((number, order))
        if self.script.rng.random() >= LATE:
            self.work(key)

    def work(self, key: str) -> None:
        """Makes every order that waits, in any order."""
        while self.waiting:
            number, order = self.waiting.pop(int(self.script.rng.integers(len(self.waiting))))
            lost = self.script.rng.random() < LOST
            made = self.script.one(None, "the mesh would fold.", b"\xff") if lost else self._made(order)
            outcome = self.session.finish_order(number, made)
            self._record(key, outcome)
            self.file.apply(outcome.changes)
            self.waiting += outcome.orders

    def _made(self, order: EditOrder) -> bytes | str:
        try:
            return encode(self.craft.run(order))
        except ValueError as error:
            return str(error)

    def _record(self, key: str, outcome: Outcome) -> None:
        self.outcomes += 1
        key = f"{key} {self.outcomes:04d}"
        recording = self.recording
        replies = []
        for place, each in enumerate(outcome.replies):
            plain, text = without_sentence(each.message)
            replies.append((each.who, plain))
            if text:
                recording.sentence(f"editing {key} {place}", text)
        for place, kept in enumerate(outcome.kept):
            if kept.trouble:
                recording.sentence(f"editing {key} kept {place}", kept.trouble)
        recording.data("editing: messages", key, repr(replies).encode())
        recording.data("editing: changes", key, plainly(outcome.changes))
        recording.data("editing: orders", key, plainly([order for _, order in outcome.orders]))
        kept_plainly = [(kept.ticket, kept.item, kept.name, kept.label, kept.kind) for kept in outcome.kept]
        recording.data("editing: kept", key, repr((kept_plainly, outcome.cast, self.session.digest)).encode())
        self.script.items = len(self.session.stored().items)


def without_sentence(message: wire.ToEditor) -> tuple[bytes, str]:
    """A message's bytes with nothing that may be reworded, and what was."""
    if isinstance(message, wire.EditRefused):
        return encode(msgspec.structs.replace(message, reason="")), message.reason
    if isinstance(message, wire.Saved):
        return encode(msgspec.structs.replace(message, sentence="")), message.sentence
    return encode(message), ""


def plainly(structs: Iterable[msgspec.Struct]) -> bytes:
    """Structs as bytes without the names of their classes, which are nobody's outside."""
    return msgspec.msgpack.encode(
        [{**msgspec.to_builtins(each, builtin_types=(bytes,)), "type": ""} for each in structs]
    )


def record_session(recording: Recording) -> None:
    """Editors at one show file: a scripted beginning, then at random, a server that starts anew, an import."""
    cast = load_cast()
    net = default_net(cast.space)
    script = Script(cast, net, np.random.default_rng(SEED))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "same.omote"
        file = open_show(path)
        house = House(recording, cast, file, script, OrderRunner(cast), _session(cast, file, net))
        for step in range(STEPS):
            if step == STEPS // 2:
                house.work("before the restart")
                house.session = _session(cast, file, net)
            _step(house, f"{step:03d}")
        house.work("at the end")
        file.apply([StoredDocument("layout", "console", b"{}")])
        _record_cast(house)
        _record_import(house)
        file.close()
        _record_file(recording, path)


def _session(cast: Cast, file: ShowFile, net: tuple[int, ...]) -> EditSession:
    return EditSession(cast, file.stored(), file.contents(), net=net, welcome=build_welcome(cast))


def _step(house: House, key: str) -> None:
    script = house.script
    rng = house.script.rng
    who = script.one(*PAGES, *["ann", "bob"] * 5)
    on_air = OnAir({"kaori": 0.75, "dog": 0.25}, {"smile": 0.5, "neutral": 0.5}, {"jawOpen": 0.3}, frozenset({"grin"}))
    if who not in house.session.crew and who != "stranger":
        house.ask(f"{key} greets", who, encode(wire.Greet(PAGES[who], who.title(), wire.EDITING_VERSION)), on_air)
    kinds = {item.id: item.kind for item in house.session.stored().items}
    member = house.session.crew.get(who)
    script.mine = [(item, kinds[item]) for item in member.open] if member is not None else []
    chance = rng.random()
    if chance < 0.04:
        house.ask(key, who, script.one(*BROKEN, rng.bytes(40), encode(wire.Greet("eve", "Eve", 99))), on_air)
    elif chance < 0.08:
        house.settle(key, _keep(house, on_air, key))
    elif chance < 0.1:
        house.settle(key, house.session.leave(who))
    else:
        house.ask(key, who, encode(script.message()), on_air)  # type: ignore[arg-type]


def _keep(house: House, on_air: OnAir, key: str) -> Outcome:
    script = house.script
    kind = script.one("face", "expression")
    label = script.one(None, "Kept")
    return keep_on_air(
        house.session,
        "face" if kind == "face" else "expression",
        on_air,
        label=label,
        wall=WALL,
        editor="console",
        ticket=key,
    )


def _record_cast(house: House) -> None:
    """What plays then: the cast's digest, and every content's bytes."""
    session = house.session
    recording = house.recording
    for key, data in sorted(session.contents.items()):
        recording.data("editing: contents", key, data)
    troupe = build_playing_cast(house.cast, session.own(), session.contents)
    recording.data("editing: cast that plays", "digest", troupe.digest.encode())
    recording.data("editing: cast that plays", "names", repr(([*troupe.faces], [*troupe.expressions])).encode())


def _record_import(house: House) -> None:
    """Expressions mailed, read again and adopted, own and built-in ones."""
    cast = house.cast
    file = house.file
    recording = house.recording
    stored = file.stored()
    contents = file.contents()
    arrivals = []
    own = [item.name for item in stored.items if item.kind == "expression" and item.head]
    for name in (*own[:4], "smile", "eyeBlinkLeft"):
        document = export_document(cast, stored, contents, name)
        recording.data("expression JSON", name, expression_bytes(document))
        arrivals.append(import_document(cast.space, document, note="by mail"))
    net = house.script.net
    alone = Recipe(net, tuple(house.script.vectors()[: len(net)]))
    if len(alone.vectors) == len(net):
        made = make_document(cast.space, "Alone", ["mine"], cast.expressions["smile"], alone)
        recording.data("expression JSON", "control points alone", expression_bytes(made))
    arrivals.append(ImportedItem("A dog", (cast.faces["dog"], cast.looks["dog"]), ("animal",)))
    changes = changes_to_import(cast, stored, arrivals, wall=WALL)
    recording.data("editing: changes", "imported", plainly(changes))
    file.apply(changes)


def _record_file(recording: Recording, path: Path) -> None:
    """The show file, table by table, and what `omote file check` says of it."""
    with closing(sqlite3.connect(path)) as connection:
        tables = connection.execute("SELECT name, sql FROM sqlite_master ORDER BY name").fetchall()
        recording.data("show file", "schema", repr(tables).encode())
        for name, sql in tables:
            if sql and sql.upper().startswith("CREATE TABLE"):
                rows = connection.execute(f'SELECT * FROM "{name}"').fetchall()
                recording.data("show file", f"table {name}", repr(sorted(map(repr, rows))).encode())
    for place, (good, sentence) in enumerate(verdicts(path)):
        recording.data("show file", f"verdict {place}", repr(good).encode())
        recording.sentence(f"verdict {place}", sentence)
