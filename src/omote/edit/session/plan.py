"""Plans and results of requests: the order that the workshop computes, and the changes and replies that follow."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import msgspec

from omote.edit.protocol.messages import ToEditor
from omote.edit.protocol.orders import Bake, Baked, EditOrder
from omote.edit.protocol.validation import Bounds, check_recipe
from omote.edit.store.authored_state import AuthoredState, DraftKey
from omote.edit.store.content_store import ContentStore
from omote.edit.store.sources import SourceResolver
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, AnyRecipe, Recipe, sources
from omote.showfile.changes import Change, Item, Kind
from omote.stage_data.assets import face_label


@dataclass(frozen=True)
class Authored:
    """The data that requests work on: the built-in cast, the authored state, contents, and the bounds of recipes.

    net: the control points of a new expression.
    """

    base: Cast
    state: AuthoredState
    store: ContentStore
    sources: SourceResolver
    bounds: Bounds
    net: tuple[int, ...]

    def resolve_and_check(self, recipe: AnyRecipe) -> AnyRecipe:
        """Resolves a recipe's sources and validates it; Refusal where it is invalid."""
        resolved = self.sources.resolve_recipe(recipe)
        check_recipe(resolved, self.bounds)
        return resolved

    def bake(self, recipe: AnyRecipe, *, with_net: bool = False) -> Bake:
        """The order that makes a recipe's expression or face.

        recipe: resolved; with_net: whether the document of its net is asked for.
        """
        return Bake(recipe, self.sources.contents(recipe), with_net and isinstance(recipe, Recipe))

    def changes_to_keep(self, recipe: AnyRecipe) -> tuple[Change, ...]:
        """The changes that store every content that the recipe refers to."""
        keys = sorted(source.removeprefix(KEY) for source in sources(recipe) if source.startswith(KEY))
        return tuple(change for key in keys for change in self.store.changes_to_keep(key))

    def labels(self, kind: Kind, *, but: int = 0) -> list[str]:
        """The labels of the faces, the expressions or the poses that can be called; but: an item that does not count.

        kind: which of them.
        """
        own = [item for item in self.state.items.values() if item.kind == kind and not item.deleted and item.id != but]
        built_in = {
            "face": [face_label(name) for name in self.base.faces],
            "expression": [title.label for title in self.base.titles.values()],
            "pose": [pose.label for pose in self.base.poses.values()],
        }
        return [*built_in[kind], *(item.label for item in own)]

    def names(self) -> set[str]:
        """All names that are taken."""
        return {
            *self.base.faces,
            *self.base.expressions,
            *self.base.poses,
            *(item.name for item in self.state.items.values()),
        }


class KeepOutcome(msgspec.Struct, frozen=True):
    """The result of what a console asked of an item: the new item, or the one that was changed, or the trouble, in one
    sentence.

    ticket: the caller's identifier; before: the label that a changed item had, "" for a new one.
    """

    ticket: str
    item: int = 0
    name: str = ""
    label: str = ""
    kind: Kind = "expression"
    trouble: str = ""
    before: str = ""


@dataclass(frozen=True)
class Result:
    """The result of a request: changes to commit, then a reply, or the state of a draft.

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
        """Whether the list of items may have changed."""
        moved = self.opened is not None or self.closed is not None
        return moved or any(isinstance(change, Item) for change in self.changes)


@dataclass(frozen=True)
class Plan:
    """An order for the workshop, and what its answer leads to; finish may raise Refusal."""

    order: EditOrder
    finish: Callable[[Baked], Result] = field(repr=False)
