"""Draws what editors ask for, from a seed: requests that are obeyed and requests that are refused."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import TypeVar

import numpy as np

from omote.edit.protocol import messages as wire
from omote.model.cast import Cast
from omote.model.controls.face_muscles import muscle_fields
from omote.model.recipes.face_handles import default_handles
from omote.model.recipes.recipe import FaceRecipe, Layer, Pull
from omote.model.space.head_regions import REGIONS
from omote.show.declaration import Message

Value = TypeVar("Value")


@dataclass
class Script:
    """Draws what editors ask for."""

    cast: Cast
    net: tuple[int, ...]
    rng: np.random.Generator
    items: int = 1
    number: int = 0
    mine: list[tuple[int, str]] = field(default_factory=list)

    def one(self, *values: Value) -> Value:
        """One of these."""
        return values[int(self.rng.integers(len(values)))]

    def item(self, *kinds: str) -> int:
        """An item, seldom one that is not there; with kinds: mostly one of them that the page has open."""
        if self.rng.random() < 0.02:
            return 99
        mine = [item for item, kind in self.mine if kind in kinds]
        return self.one(*mine) if mine and self.rng.random() < 0.93 else 1 + int(self.rng.integers(max(self.items, 1)))

    def amount(self) -> float:
        """A weight, seldom one that is refused."""
        return (
            self.one(9.0, float("nan"), -3.0)
            if self.rng.random() < 0.03
            else round(float(self.rng.uniform(-0.2, 0.9)), 3)
        )

    def label(self) -> str:
        """What people read of an item."""
        return self.one("Grin", "Großmutter", "grin", "  A long face ", "\n", "x" * 80, "Élan vital", "Cat 2")

    def start(self) -> dict[str, float]:
        """What a new expression begins from."""
        return self.one({}, {"smile": self.amount()}, {"smirk": 1.0})

    def muscle(self) -> str:
        """The name of a muscle, seldom of none."""
        return self.one(*muscle_fields(self.cast.space), "biceps")

    def tags(self) -> list[str]:
        """Tags of an item."""
        return self.one([], ["a", "b", "a"])

    def message(self) -> Message:
        """A request under a number of its own."""
        self.number += 1
        kinds = [*REQUESTS]
        weights = np.array([WEIGHT.get(kind, 1.0) for kind in kinds])
        made = REQUESTS[kinds[int(self.rng.choice(len(kinds), p=weights / weights.sum()))]]
        return made(self, self.number)

    def mix(self, names: Iterable[str]) -> dict[str, float]:
        """Faces by weight that sum to one, seldom to another number."""
        share = round(float(self.rng.uniform(0.1, 0.9)), 3)
        known = [*names]
        return {self.one(*known): share} | {self.one(*known): self.one(1.0 - share, 1.0 - share, 1.0 - share, 0.5)}

    def vectors(self) -> list[tuple[float, float, float]]:
        """A vector for each control point, nearly at rest."""
        rows = self.rng.normal([0.0, 0.0, 1.0], [0.008, 0.001, 0.004], (len(self.net), 3)).tolist()
        return [(x, y, z) for x, y, z in rows][: None if self.rng.random() < 0.95 else -1]

    def face_recipe(self) -> FaceRecipe:
        """A face of faces, regions, caricature and handles."""
        handles = [handle.row for handle in default_handles(self.cast.space)]
        rows = self.one((), tuple(handles))
        ways = self.rng.normal(0.0, 0.001, (len(rows), 3)).tolist()
        regions: dict[str, str] = {self.one(*REGIONS): self.one(*self.cast.faces)} if self.rng.random() < 0.6 else {}
        amount = self.one(1.0, 1.0, 1.2, 0.7, 8.0)
        return FaceRecipe(self.mix(self.cast.faces), regions, amount, rows, tuple((x, y, z) for x, y, z in ways))


def _drag(script: Script, number: int) -> Message:
    points = script.rng.choice(len(script.net), size=int(script.rng.integers(1, 3)), replace=False).tolist()
    rows = script.cast.faces["kaori"].positions[[script.net[point] for point in points]].astype(np.float64)
    there = (rows + script.rng.normal(0.0, 0.002, rows.shape)).tolist()
    rest = [(0.0, 0.0, 1.0)] * len(script.net)
    return wire.DragPoints(
        number, script.item("expression"), script.one("kaori", "kaori", "nobody"), points, there, rest
    )


def _layers(script: Script, number: int) -> Message:
    names = script.rng.choice(
        [*script.cast.expressions, "grin", "nothing"], size=int(script.rng.integers(0, 4))
    ).tolist()
    regions = (None, None, *REGIONS)
    layers = [Layer(x, x, script.amount(), script.one(*regions), bool(script.rng.random() < 0.3)) for x in names]
    return wire.SetLayers(number, script.item("expression"), layers)


def _net(script: Script, number: int) -> Message:
    net = list(script.net)
    dropped = int(script.rng.integers(1, len(net) - 3))
    return wire.SetNet(
        number, script.item("expression"), script.one(net, net[:dropped] + net[dropped + 1 :], [5, 5, 5], [1, 2])
    )


REQUESTS: dict[str, Callable[[Script, int], Message]] = {
    "create": lambda s, n: wire.CreateExpression(n, s.label(), s.start(), s.one(False, True)),
    "create face": lambda s, n: wire.CreateFace(n, s.label(), s.mix([*s.cast.faces]), s.one(False, False, True)),
    "open": lambda s, n: wire.OpenItem(n, s.item()),
    "close": lambda s, n: wire.CloseItem(n, s.item()),
    "drag": _drag,
    "vectors": lambda s, n: wire.SetVectors(n, s.item("expression"), s.vectors(), s.one("mirrored", "pasted", "\x00")),
    "net": _net,
    "layers": _layers,
    "pulls": lambda s, n: wire.SetPulls(n, s.item("expression"), [Pull(s.muscle(), s.amount())]),
    "eyes": lambda s, n: wire.SetEyes(n, s.item("expression"), (s.amount(), 0.0, s.amount(), 0.1), s.amount()),
    "flatten": lambda s, n: wire.Flatten(n, s.item("expression")),
    "face": lambda s, n: wire.SetFace(n, s.item("face"), s.face_recipe(), "mix"),
    "undo": lambda s, n: wire.Undo(n, s.item("expression", "face")),
    "redo": lambda s, n: wire.Redo(n, s.item("expression", "face")),
    "save": lambda s, n: wire.Save(n, s.item("expression", "face"), s.one("", "better", "\x07")),
    "bring back": lambda s, n: wire.BringBack(n, s.item("expression", "face"), s.one(1, 1, 2, 7)),
    "describe": lambda s, n: wire.Describe(n, s.item(), s.label(), s.tags(), s.one(0.5, 3.0, float("inf"))),
    "duplicate": lambda s, n: wire.Duplicate(n, s.item(), s.label()),
    "delete": lambda s, n: wire.Delete(n, s.item()),
    "restore": lambda s, n: wire.Restore(n, s.item()),
    "history": lambda s, n: wire.AskHistory(n, s.item()),
}  # fmt: skip
WEIGHT = {
    "open": 4.0, "layers": 2.0, "pulls": 2.0, "vectors": 2.0, "face": 2.0, "undo": 2.0, "save": 4.0, "delete": 0.5,
    "restore": 1.5,
}  # fmt: skip
