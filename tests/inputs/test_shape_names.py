"""Each spelling of a shape's name means what the same shape means in ours; other names mean nothing."""

from __future__ import annotations

import pytest

from omote.builtin import load_cast
from omote.inputs.shape_names import GAZE, JAW, LIDS, LIPS, WHOLE, ShapeMeaning, read_shape_name
from omote.inputs.trackers.arkit_names import ARKIT_NAMES
from omote.interchange.avatar.preset_expressions import EMOTIONS, PRESETS, UNITS, VOWELS
from omote.interchange.avatar.vrm0_extension import PRESETS as VRM0
from omote.model.action_units import MAKEHUMAN, action_units
from omote.perform.speech.visemes import VISEMES

CAST = load_cast()


def test_arkit_s_names_are_their_units_in_each_spelling() -> None:
    for unit in ARKIT_NAMES:
        sided = unit.startswith(("eye", "mouth", "brow"))
        short = unit.replace("Left", "_L").replace("Right", "_R") if sided else unit
        for spelling in (unit, unit[0].upper() + unit[1:], f"head.{unit}", short):
            assert read_shape_name(spelling).units == (unit,)


def test_units_of_both_sides_and_halves_of_whole_ones_are_found() -> None:
    assert read_shape_name("mouthSmile").units == ("mouthSmileLeft", "mouthSmileRight")
    assert read_shape_name("cheekPuff_L").units == read_shape_name("cheekPuffRight").units == ("cheekPuff",)
    assert read_shape_name("browInnerUp_L").units == ("browInnerUp",)


def test_presets_of_vrm_mean_the_same_in_both_versions() -> None:
    for preset in PRESETS:
        meaning = read_shape_name(preset)
        assert meaning.units == UNITS.get(preset, ())
        assert meaning.named == {**EMOTIONS, **VOWELS}.get(preset, "")
        assert read_shape_name(VRM0.get(preset, preset)) == meaning
        assert read_shape_name(preset.upper()) == meaning
    assert read_shape_name("happy").part == WHOLE
    assert {read_shape_name(preset).part for preset in VOWELS} == {LIPS}
    assert {read_shape_name(f"look{way}").part for way in ("Up", "Down", "Left", "Right")} == {GAZE}
    assert {read_shape_name(name).part for name in ("blink", "blinkLeft", "blink_r", "EyesClosed")} == {LIDS}


@pytest.mark.parametrize(
    ("vroid", "preset"),
    [("Fcl_ALL_Joy", "happy"), ("Fcl_MTH_A", "aa"), ("Face.M_F00_000_00_Fcl_EYE_Close_L", "blinkLeft")],
)
def test_names_of_vroid_are_vrm_s(vroid: str, preset: str) -> None:
    assert read_shape_name(vroid) == read_shape_name(preset)


@pytest.mark.parametrize("viseme", VISEMES)
def test_visemes_are_found_as_oculus_and_vrchat_write_them(viseme: str) -> None:
    meaning = ShapeMeaning(named=viseme, part=LIPS)
    written = (f"viseme_{viseme}", f"Viseme_{viseme.lower()}", f"vrc.v_{viseme.lower()}", f"head.viseme_{viseme}")
    assert {read_shape_name(each) for each in written} == {meaning}


def test_oculus_and_vrm_mean_the_same_vowels() -> None:
    for preset, viseme in VOWELS.items():
        assert read_shape_name(preset) == read_shape_name(f"viseme_{viseme}") == read_shape_name(f"vrc.v_{preset}")


def test_action_units_are_the_channels_of_their_numbers() -> None:
    for name, number in (("AU12_L", "L12"), ("AU45R", "R45"), ("au_06_r", "R6"), ("AU 1", "1"), ("L12", "L12")):
        (unit,) = read_shape_name(name).units
        assert action_units(unit) == (number,)
    assert read_shape_name("AU1+2").units == (*read_shape_name("AU1").units, *read_shape_name("AU2").units)
    assert read_shape_name("AU1+AU99") == ShapeMeaning()
    assert read_shape_name("Lip_Corner_Puller") == read_shape_name("AU12")
    assert read_shape_name("AU61").part == GAZE
    assert read_shape_name("AU26").part == JAW


def test_units_of_makehuman_are_those_of_the_cast() -> None:
    mine = [name for name, title in CAST.titles.items() if title.kind == "makehuman" and action_units(name)]
    for unit in mine:
        assert read_shape_name(unit).units == (unit,)
        assert read_shape_name(unit.title().replace("-", "")).units == (unit,)
    assert read_shape_name("eye-closure").units == ("eye-left-closure", "eye-right-closure")
    assert {unit for name in MAKEHUMAN for unit in read_shape_name(name).units} == set(mine)


@pytest.mark.parametrize(
    "name", ["Agape", "Basis", "target_0", "shape12", "12", "b2", "AU30", "neutral", "", "v_", "+"]
)
def test_nothing_is_guessed(name: str) -> None:
    assert read_shape_name(name) == ShapeMeaning()
    assert read_shape_name(name).tags == ()


def test_tags_are_units_and_part() -> None:
    assert read_shape_name("blink").tags == ("eyeBlinkLeft", "eyeBlinkRight", "lids")
    assert read_shape_name("sorrow").tags == ("sad", "face")
