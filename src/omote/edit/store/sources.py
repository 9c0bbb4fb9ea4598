"""Resolves the sources of recipes: names of the built-in cast, and contents by key."""

from __future__ import annotations

from msgspec.structs import replace

from omote.edit.store.authored_state import AuthoredState
from omote.edit.store.content_store import ContentStore
from omote.model.body.pose_recipe import PoseRecipe
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY, AnyRecipe, Recipe, sources
from omote.perform.limits import check_known
from omote.show.validation import Refusal
from omote.showfile.changes import Kind
from omote.showfile.contents import ContentError, unpack_pose


class SourceResolver:
    """Resolves sources; the name of an authored item becomes the permanent key of what it plays."""

    def __init__(self, base: Cast, state: AuthoredState, store: ContentStore) -> None:
        self._built_in = {"face": base.faces, "expression": base.expressions, "pose": base.poses}
        self._poses = {} if base.figures is None else base.figures.recipes
        self._titles = {name: title.label for name, title in base.titles.items()}
        self._state = state
        self._store = store

    def resolve(self, kind: Kind, source: str) -> str:
        """A name of the built-in cast, or `#` and the key of a content that is there; Refusal for anything else.

        kind: of what is meant; source: a name, or `#` and a key.
        """
        if source.startswith(KEY):
            if source.removeprefix(KEY) in self._store:
                return source
            raise Refusal(f"what {source[:80]!r} names is not there any more: choose it again.")
        own = self._state.find(source)
        if own is None or own.kind != kind or own.deleted:
            return self._resolve_built_in(kind, source)
        head = self._state.head(own)
        if head is None:
            raise Refusal(f"nothing of {own.label!r} has been saved yet: save it first.")
        return KEY + head.content

    def resolve_recipe(self, recipe: AnyRecipe) -> AnyRecipe:
        """The recipe with every source resolved."""
        if isinstance(recipe, Recipe):
            layers = tuple(replace(x, source=self.resolve("expression", x.source)) for x in recipe.layers)
            ground = None if recipe.ground is None else self.resolve("expression", recipe.ground)
            return replace(recipe, layers=layers, ground=ground)
        if isinstance(recipe, PoseRecipe):
            return recipe
        base: dict[str, float] = {}
        for source, weight in recipe.base.items():
            resolved = self.resolve("face", source)
            base[resolved] = base.get(resolved, 0.0) + weight
        regions = {region: self.resolve("face", source) for region, source in recipe.regions.items()}
        return replace(recipe, base=base, regions=regions)

    def label(self, kind: Kind, source: str) -> str:
        """The label of a source, for people.

        kind: of what is meant; source: a name, or `#` and a key.
        """
        own = self._state.find(source)
        if own is not None and own.kind == kind:
            return own.label
        key = source.removeprefix(KEY)
        for item, revisions in self._state.revisions.items():
            if any(revision.content == key for revision in revisions.values()):
                return self._state.items[item].label
        return self._titles.get(source, source[:12] if source.startswith(KEY) else source)

    def pose_recipe(self, source: str) -> PoseRecipe:
        """What a pose was made from: an own one, one of the library, or the stand; Refusal for anything else.

        source: a name, or `#` and a key.
        """
        resolved = self.resolve("pose", source)
        if not resolved.startswith(KEY):
            written = self._poses.get(resolved, PoseRecipe())
            return PoseRecipe(**{name: getattr(written, name) for name in PoseRecipe.__struct_fields__})
        try:
            return unpack_pose(self._store[resolved.removeprefix(KEY)])
        except ContentError as error:
            raise Refusal(f"{source[:80]!r} is no pose: {error}.") from error

    def contents(self, recipe: AnyRecipe, *more: str) -> dict[str, bytes]:
        """The bytes of everything that a recipe names, and of `more` sources; Refusal where one is gone."""
        keys = (source.removeprefix(KEY) for source in sorted({*sources(recipe), *more}) if source.startswith(KEY))
        try:
            return {key: self._store[key] for key in keys}
        except KeyError as error:
            raise Refusal(f"content {str(error.args[0])[:80]!r} is not there any more: choose it again.") from error

    def _resolve_built_in(self, kind: Kind, source: str) -> str:
        built_in = self._built_in[kind]
        own = (item.name for item in self._state.items.values() if item.kind == kind and not item.deleted)
        try:
            check_known(source, built_in if source in built_in else sorted({*own, *built_in}), kind)
        except ValueError as error:
            raise Refusal(f"{error}.") from error
        return source
