"""Converts what is on air into recipes that reproduce it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from msgspec import structs

from omote.edit.store.sources import SourceResolver
from omote.model.known_names import NEUTRAL, PlayRegion
from omote.model.recipes.recipe import AnyRecipe, FaceRecipe, Layer, Recipe
from omote.model.space.head_regions import REGIONS_OF, Region
from omote.perform.mix import combine
from omote.perform.springs.cast_springs import without_springs
from omote.show.objects.state import CallState, CharacterState, State
from omote.show.validation import Refusal
from omote.showfile.changes import Kind


@dataclass(frozen=True)
class OnAir:
    """Weights by name of what a character has on air, and of the regions that show another mix of expressions; over all
    characters, the home faces and the names of what else is on air or coming (called, or held by a T-bar)."""

    faces: Mapping[str, float] = field(default_factory=dict)
    expressions: Mapping[str, float] = field(default_factory=dict)
    channels: Mapping[str, float] = field(default_factory=dict)
    coming: frozenset[str] = frozenset()
    homes: frozenset[str] = frozenset()
    regions: Mapping[PlayRegion, Mapping[str, float]] = field(default_factory=dict)

    @property
    def names(self) -> frozenset[str]:
        """All names in use, which must not be removed now."""
        weights = (self.faces, self.expressions, self.channels, *self.regions.values())
        return self.coming | {name for mix in weights for name, weight in mix.items() if weight}


def read_on_air(state: State, character: str = "") -> OnAir:
    """What a character has on air in a show's state: the one named, else the first that is on the stage; channels as
    they act, the gaze's part included."""
    all_of_them = state.characters
    on_stage = (name for name, character_state in all_of_them.items() if character_state.presence > 0.0)
    shown = all_of_them[character if character in all_of_them else next(on_stage, next(iter(all_of_them)))]
    coming = {call.target for character_state in all_of_them.values() for call in calls_of(character_state)}
    coming.update(*(_seen(character_state).names for character_state in all_of_them.values()))
    homes = frozenset(character_state.home_face for character_state in all_of_them.values())
    return replace(_seen(shown), coming=frozenset(coming), homes=homes)


def _seen(character: CharacterState) -> OnAir:
    """What one character alone shows."""
    regions = character.regions
    return OnAir(character.faces, character.expressions, channels_of(character), regions=regions)


def calls_of(character: CharacterState) -> list[CallState]:
    """All calls that run: of faces, of expressions, and of those in regions."""
    calls = (character.face_call, character.expression_call, *character.region_calls.values())
    return [call for call in calls if call is not None]


def channels_of(character: CharacterState) -> dict[str, float]:
    """The channels of a character as they act, the gaze's part included, without what its springs add for a moment."""
    shown = without_springs(character.channels, None if character.held is None else character.held.channels)
    names = (*shown, *(name for name in character.added if name not in shown))
    return {name: shown.get(name, 0.0) + character.added.get(name, 0.0) for name in names}


def neutral_recipe(net: tuple[int, ...]) -> Recipe:
    """The recipe of an expression at rest, on a net."""
    return Recipe(net=net, vectors=((0.0, 0.0, 1.0),) * len(net))


def recipe_on_air(kind: Kind, on_air: OnAir, net: tuple[int, ...], sources: SourceResolver) -> AnyRecipe:
    """The recipe of the face or the expression that is on air.

    kind: of the item; on_air: what shows; net: control points, rows of the skin; sources: resolve names.
    """
    if kind == "face":
        return face_recipe(on_air.faces, sources)
    together = (*on_air.expressions.items(), *on_air.channels.items())
    whole = expression_recipe([(name, weight) for name, weight in together if weight], net, sources)
    return structs.replace(whole, layers=(*whole.layers, *_regional_layers(on_air, sources)))


def _regional_layers(on_air: OnAir, sources: SourceResolver) -> list[Layer]:
    """What regions show beyond the whole face, as layers on the regions of the head that each consists of."""
    more = {region: combine(((1.0, mix), (-1.0, on_air.expressions))) for region, mix in sorted(on_air.regions.items())}
    return [
        layer
        for region, weights in more.items()
        for part in REGIONS_OF[region]
        for layer in _layers([*weights.items()], sources, part)
    ]


def face_recipe(weights: Mapping[str, float], sources: SourceResolver) -> FaceRecipe:
    """The recipe of a mix of faces; Refusal for none.

    weights: by name; sources: resolve names.
    """
    base: dict[str, float] = {}
    for name, weight in weights.items():
        source = sources.resolve("face", name)
        if weight:
            base[source] = base.get(source, 0.0) + weight
    if not base:
        raise Refusal("the new face begins from no face: give the face that it is made from.")
    return FaceRecipe(base=base)


def expression_recipe(weights: list[tuple[str, float]], net: tuple[int, ...], sources: SourceResolver) -> Recipe:
    """The recipe of weighted expressions as layers; neutral needs none.

    weights: names with theirs; net: control points, rows of the skin; sources: resolve names.
    """
    return Recipe(net=net, vectors=neutral_recipe(net).vectors, layers=_layers(weights, sources))


def _layers(
    weights: Sequence[tuple[str, float]], sources: SourceResolver, region: Region | None = None
) -> tuple[Layer, ...]:
    return tuple(
        Layer(sources.resolve("expression", name), sources.label("expression", name), weight, region)
        for name, weight in weights
        if name != NEUTRAL and weight
    )
