"""Converts what is on air into recipes that reproduce it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from omote.edit.store.sources import Sources
from omote.model.known_names import NEUTRAL
from omote.model.recipes.recipe import FaceRecipe, Layer, Recipe
from omote.show.messages import State
from omote.show.validation import Refusal
from omote.showfile.changes import Kind


@dataclass(frozen=True)
class OnAir:
    """Weights by name of what is on air, the names of what is coming (called, or held by a T-bar), the home face."""

    faces: Mapping[str, float] = field(default_factory=dict)
    expressions: Mapping[str, float] = field(default_factory=dict)
    channels: Mapping[str, float] = field(default_factory=dict)
    coming: frozenset[str] = frozenset()
    home: str = ""

    @property
    def names(self) -> frozenset[str]:
        """All names in use, which must not be removed now."""
        weights = (self.faces, self.expressions, self.channels)
        return self.coming | {name for each in weights for name, weight in each.items() if weight}


def read_on_air(state: State) -> OnAir:
    """What a show's state has on air; channels as they act, the gaze's part included."""
    calls = (call for call in (state.face_call, state.expression_call) if call is not None)
    names = (*state.channels, *(name for name in state.lids if name not in state.channels))
    channels = {name: state.channels.get(name, 0.0) + state.lids.get(name, 0.0) for name in names}
    coming = frozenset(call.target for call in calls)
    return OnAir(state.faces, state.expressions, channels, coming, state.home_face)


def neutral_recipe(net: tuple[int, ...]) -> Recipe:
    """The recipe of an expression at rest, on a net."""
    return Recipe(net=net, vectors=((0.0, 0.0, 1.0),) * len(net))


def recipe_on_air(kind: Kind, on_air: OnAir, net: tuple[int, ...], sources: Sources) -> Recipe | FaceRecipe:
    """The recipe of the face or the expression that is on air."""
    if kind == "face":
        return face_recipe(on_air.faces, sources)
    together = (*on_air.expressions.items(), *on_air.channels.items())
    return expression_recipe([(name, weight) for name, weight in together if weight], net, sources)


def face_recipe(weights: Mapping[str, float], sources: Sources) -> FaceRecipe:
    """The recipe of a mix of faces; Refusal for none."""
    base: dict[str, float] = {}
    for name, weight in weights.items():
        source = sources.resolve("face", name)
        if weight:
            base[source] = base.get(source, 0.0) + weight
    if not base:
        raise Refusal("the new face begins from no face: give the face that it is made from.")
    return FaceRecipe(base=base)


def expression_recipe(weights: list[tuple[str, float]], net: tuple[int, ...], sources: Sources) -> Recipe:
    """The recipe of weighted expressions as layers; neutral needs none."""
    layers = tuple(
        Layer(sources.resolve("expression", name), sources.label("expression", name), weight)
        for name, weight in weights
        if name != NEUTRAL and weight
    )
    return Recipe(net=net, vectors=neutral_recipe(net).vectors, layers=layers)
