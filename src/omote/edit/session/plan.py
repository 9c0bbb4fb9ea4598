"""How a request is carried out: what the workshop must make for it, and what follows from that."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import msgspec

from omote.edit.protocol.messages import ToEditor
from omote.edit.protocol.orders import Bake, Baked, EditOrder
from omote.edit.protocol.validation import Bounds, check_recipe
from omote.edit.store.authored_state import AuthoredState, DraftKey
from omote.edit.store.content_store import ContentStore
from omote.edit.store.sources import Sources
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, FaceRecipe, Recipe, sources
from omote.showfile.changes import Change, Kind, PutItem


@dataclass(frozen=True)
class Authored:
    """All that requests are about: the built-in cast, the authored work, contents, and what recipes may say.

    net: the control points of a new expression.
    """

    base: Cast
    state: AuthoredState
    store: ContentStore
    sources: Sources
    bounds: Bounds
    net: tuple[int, ...]

    def resolve_and_check(self, recipe: Recipe | FaceRecipe) -> Recipe | FaceRecipe:
        """The recipe with its sources resolved; Refusal where it says what it must not."""
        found = self.sources.resolve_recipe(recipe)
        check_recipe(found, self.bounds)
        return found

    def bake(self, recipe: Recipe | FaceRecipe, *, with_net: bool = False) -> Bake:
        """The order that makes a recipe's expression or face."""
        return Bake(recipe, self.sources.contents(recipe), with_net and isinstance(recipe, Recipe))

    def kept(self, recipe: Recipe | FaceRecipe) -> tuple[Change, ...]:
        """What the show file must be given so that the recipe can be made again."""
        keys = sorted(source.removeprefix(KEY) for source in sources(recipe) if source.startswith(KEY))
        return tuple(change for key in keys for change in self.store.changes_to_keep(key))

    def names(self) -> set[str]:
        """Every name that a new item must not have."""
        return {*self.base.faces, *self.base.expressions, *(item.name for item in self.state.items.values())}


class KeepOutcome(msgspec.Struct, frozen=True):
    """What became of one press of "save what is on air": the new item, or the trouble, in one sentence.

    ticket: what the caller gave, to know it by.
    """

    ticket: str
    item: int = 0
    name: str = ""
    label: str = ""
    kind: Kind = "expression"
    trouble: str = ""


@dataclass(frozen=True)
class Result:
    """What a request leads to: changes to commit, then a reply, or the state of a draft.

    opened, closed: the item that the page has open from now on, or no longer; whole: the draft's net goes with it.
    """

    changes: tuple[Change, ...] = ()
    reply: ToEditor | None = None
    draft: DraftKey | None = None
    opened: int | None = None
    closed: int | None = None
    whole: bool = False
    miss: float = 0.0
    kept: KeepOutcome | None = None

    @property
    def lists(self) -> bool:
        """Whether the list of items may be another after it."""
        moved = self.opened is not None or self.closed is not None
        return moved or any(isinstance(change, PutItem) for change in self.changes)


@dataclass(frozen=True)
class Plan:
    """An order for the workshop, and what its answer leads to; finish may raise Refusal."""

    order: EditOrder
    finish: Callable[[Baked], Result] = field(repr=False)
