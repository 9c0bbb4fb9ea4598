"""Which layers automatic motion may play, and whether lips speak."""

import pytest

from omote.model.cast import Cast
from omote.perform.frame import Held, with_fields
from omote.perform.layers.layer_names import DRIVEN
from omote.perform.layers.layer_vectors import Layers
from omote.perform.layers.layers import begin, drive
from omote.perform.layers.source_frame import AUTOMATIC, source_frame
from omote.perform.motion.free_layers import is_free, is_speaking
from omote.perform.performer import Performer


def driven(cast: Cast, layer: str, source: str) -> Layers:
    """Layers of which a source drives one."""
    frame = with_fields(source_frame(cast.expressions, {"jawOpen": 0.04}, None, None), source=source)
    return drive(cast, begin(cast, Held()), next(each for each in DRIVEN if each == layer), frame)


@pytest.mark.parametrize("layer", ["gaze", "breath"])
def test_a_layer_is_free_where_nothing_drives_it_or_the_character_itself_does(cast: Cast, layer: str) -> None:
    name = next(each for each in DRIVEN if each == layer)
    assert is_free(begin(cast, Held()), name)
    assert is_free(driven(cast, layer, AUTOMATIC), name)
    assert not is_free(driven(cast, layer, "phone"), name)
    assert is_free(driven(cast, "lips", "phone"), name)


def test_lips_speak_while_a_source_moves_them(cast: Cast) -> None:
    performer = Performer(cast)
    spoken = []
    for weight in [0.0] * 60 + [0.6] * 60 + [0.0] * 60:
        performer.drive({"jawOpen": weight}, layer="lips")
        performer.advance(1 / 60)
        assert performer._layers is not None
        spoken.append(is_speaking(performer._layers))
    assert (spoken[50], spoken[110], spoken[-1]) == (False, True, False)
    assert not is_speaking(driven(cast, "gaze", "phone"))
