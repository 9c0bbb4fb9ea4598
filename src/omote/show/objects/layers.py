"""How much of each layer shows."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from omote.perform.layers.layer_names import DEFAULT_SETTINGS, LAYER_PARTS, LayerName, LayerPart
from omote.perform.performer import Performer
from omote.show.declaration import CharacterCommand, RequestId
from omote.show.objects.state import CharacterState
from omote.show.osc import Osc, Value

FIRST_INFLUENCES: Mapping[str, list[float]] = {
    layer: [setting.influence[part] for part in LAYER_PARTS] for layer, setting in DEFAULT_SETTINGS.items()
}
"""The influences of layers that are as at first."""
NO_INFLUENCE = [0.0] * len(LAYER_PARTS)
PART_PLACES: Mapping[str, int] = {part: place for place, part in enumerate(LAYER_PARTS)}


def _influence(state: CharacterState, layer: str, part: str = "") -> tuple[float]:
    """The influence of a layer, as set: of a part, or the largest."""
    shown = {str(name): layer_state for name, layer_state in state.layers.items()}.get(layer)
    influence = shown.influence if shown is not None else FIRST_INFLUENCES.get(layer, NO_INFLUENCE)
    return (influence[PART_PLACES[part]] if part in PART_PLACES else max(influence),)


def _is_on(state: CharacterState, layer: str) -> tuple[float]:
    """1 where a layer is switched on, as one is that is as at first, else 0."""
    shown = {str(name): layer_state for name, layer_state in state.layers.items()}.get(layer)
    return (float(shown is None or bool(shown.on)),)


class SetLayer(CharacterCommand, frozen=True):
    """How much of a layer of a character shows, 0..1, in a region of it (`None`: everywhere), and whether it is on;
    `None` leaves either as it is. What is on air follows."""

    hand = "moves"
    osc = (
        Osc(
            "layer/{layer}",
            "sets how much of a layer shows, everywhere",
            ("influence",),
            on_air=_influence,
            reported=lambda state: ((layer,) for layer in state.layers),
        ),
        Osc(
            "layer/{layer}/{region}",
            "sets how much of a layer shows in brows, eyes, mouth, rest, head or gaze",
            ("influence",),
            on_air=_influence,
            reported=lambda _: (),
        ),
        Osc(
            "layer_on/{layer}",
            "switches a layer on (1 or true) or off (0 or false)",
            ("on",),
            on_air=_is_on,
            reported=lambda state: ((layer,) for layer in state.layers),
        ),
    )

    layer: Annotated[LayerName, Value("layer", name="name")]
    region: Annotated[LayerPart | None, Value("part")] = None
    influence: Annotated[float | None, Value()] = None
    on: Annotated[bool | None, Value("switch")] = None
    id: RequestId = ""

    def play(self, performer: Performer) -> None:
        """Plays it."""
        performer.set_layer(self.layer, region=self.region, influence=self.influence, on=self.on)

    def control(self, character: str) -> str:
        """The fader of a layer, or of a region of it."""
        whole = f"{super().control(character)}:{self.layer}"
        return whole if self.region is None else f"{whole}:{self.region}"
