"""The content-addressed store: contents in the show file, and a cache of those that drafts pass through."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import chain
from typing import TypeVar

from omote.edit.protocol.messages import NetDocument
from omote.edit.protocol.orders import Bake, Baked, EditOrder
from omote.edit.protocol.wire import write_recipe
from omote.model.recipes.recipe import AnyRecipe, Recipe
from omote.showfile.changes import Content

PASSING = 2048
"""Contents of drafts that are cached, so that undo needs no computation."""
PASSING_BYTES = 2**24
"""All of them together: some 300 faces, or five with a picture on their skin. What is dropped is computed again."""
_NETS = 16
_RECIPES = 4096

Key = TypeVar("Key")
Value = TypeVar("Value")


class ContentStore(Mapping[str, bytes]):
    """Bytes by key, and the key of each recipe's result; in_file: the contents of the show file."""

    def __init__(self, in_file: Mapping[str, bytes]) -> None:
        self._in_file = in_file
        self._given: dict[str, bytes] = {}
        self._passing: dict[str, bytes] = {}
        self._keys: dict[bytes, str] = {}
        self._nets: dict[tuple[int, ...], NetDocument] = {}

    def __getitem__(self, key: str) -> bytes:
        for place in (self._passing, self._given):
            if key in place:
                return place[key]
        return self._in_file[key]

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys(chain(self._in_file, self._given, self._passing)))

    def __len__(self) -> int:
        return len(list(iter(self)))

    def __contains__(self, key: object) -> bool:
        return key in self._passing or key in self._given or key in self._in_file

    def changes_to_keep(self, key: str) -> tuple[Content, ...]:
        """The changes that store this content in the show file; none when it is there already."""
        if key in self._given or key in self._in_file:
            return ()
        self._given = {old: data for old, data in self._given.items() if old not in self._in_file}
        self._given[key] = self._passing.pop(key)
        return (Content(key, self._given[key]),)

    def remember_recipe(self, recipe: bytes, key: str) -> None:
        """Remembers that a recipe (JSON) makes the content of this key."""
        _remember(self._keys, recipe, key, _RECIPES)

    def remember_contents(self, contents: Mapping[str, bytes]) -> None:
        """Caches contents for a while."""
        for key, data in contents.items():
            if key not in self._given and key not in self._in_file:
                _remember(self._passing, key, data, PASSING)
        self._forget_passing(spare=len(contents))

    def _forget_passing(self, spare: int) -> None:
        """Drops the oldest cached contents beyond PASSING_BYTES, but the newest `spare`."""
        total = sum(map(len, self._passing.values()))
        for key in [*self._passing][: max(0, len(self._passing) - spare)]:
            if total <= PASSING_BYTES:
                return
            total -= len(self._passing.pop(key))

    def remember_result(self, order: EditOrder, baked: Baked) -> None:
        """Caches the workshop's answer to an order, and its sources.

        order: what was asked; baked: the answer.
        """
        self.remember_contents({**order.contents, **baked.contents})
        self.remember_recipe(write_recipe(baked.recipe), baked.key)
        if isinstance(order, Bake):
            self.remember_recipe(write_recipe(order.recipe), baked.key)
        if isinstance(baked.recipe, Recipe) and baked.net is not None:
            _remember(self._nets, baked.recipe.net, baked.net, _NETS)

    def key(self, recipe: bytes) -> str:
        """The key of a recipe's (JSON) result, "" where it is not cached."""
        return self._keys.get(recipe, "")

    def recall(self, order: EditOrder) -> Baked | None:
        """The cached answer to an order, None where there is none."""
        if not isinstance(order, Bake):
            return None
        key = self._keys.get(write_recipe(order.recipe))
        net = self.net(order.recipe)
        if key is None or key not in self or (order.with_net and net is None):
            return None
        return Baked(order.recipe, key, {}, net)

    def net(self, recipe: AnyRecipe) -> NetDocument | None:
        """The cached document of a recipe's net."""
        return self._nets.get(recipe.net) if isinstance(recipe, Recipe) else None


def _remember(table: dict[Key, Value], key: Key, value: Value, most: int) -> None:
    """Adds a value as the newest of a table and removes the oldest beyond `most`."""
    table.pop(key, None)
    table[key] = value
    while len(table) > most:
        del table[next(iter(table))]
