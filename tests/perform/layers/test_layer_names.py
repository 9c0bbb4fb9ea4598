"""What an operator sets of a layer is checked, and every layer has its rule."""

import pytest

from omote.perform.layers.layer_names import (
    DEFAULT_SETTINGS,
    DRIVEN,
    LAYER_PARTS,
    LAYERS,
    RULES,
    WHOLE,
    LayerSetting,
    check_driven,
    check_layer,
    check_part,
    part_of_channel,
)


def test_what_sources_drive_has_a_rule_and_all_else_is_emotion_and_hands() -> None:
    assert tuple(RULES) == DRIVEN
    assert [layer for layer in LAYERS if layer not in DRIVEN] == ["emotion", "hands"]
    assert list(DEFAULT_SETTINGS) == list(LAYERS)


def test_an_influence_is_set_of_a_part_or_of_all() -> None:
    setting = LayerSetting().change("mouth", 0.25, None)
    assert {part: value for part, value in setting.influence.items() if value != 1.0} == {"mouth": 0.25}
    assert set(setting.change(None, 0.5, False).influence.values()) == {0.5}
    assert setting.change(None, None, False) == LayerSetting(setting.influence, on=False)


def test_what_there_is_not_is_refused_with_what_there_is() -> None:
    with pytest.raises(ValueError, match="there is no layer 'trackr'; near are tracker"):
        check_layer("trackr")
    with pytest.raises(
        ValueError, match="there is no layer for a source 'hands'; expected one of breath, gaze, blink, tracker"
    ):
        check_driven("hands")
    with pytest.raises(ValueError, match="there is no region of a layer 'nose'"):
        check_part("nose")
    with pytest.raises(ValueError, match=r"the influence of a layer is 1.5; give a number from 0 to 1"):
        LayerSetting().change("mouth", 1.5, None)
    with pytest.raises(TypeError, match="the switch of a layer is 2; give True or False"):
        LayerSetting().change(None, None, 2)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="the influence of a layer is of mouth; expected brows"):
        LayerSetting({"mouth": 1.0})


def test_a_channel_belongs_to_the_part_of_its_title() -> None:
    assert [part_of_channel(region) for region in ("brows", "eyes", "jaw", "nose", "whole", "")] == [
        0, 1, 2, 3, WHOLE, WHOLE,
    ]  # fmt: skip
    assert len(LAYER_PARTS) == WHOLE
