"""Names of coefficients: every carrier's spelling finds the same channel."""

import pytest

from omote.inputs.trackers.arkit_names import ALIASES, ARKIT_CHANNELS, ARKIT_NAMES, ChannelNames, plain_spelling
from omote.model.action_units import ARKIT


def spellings(name: str) -> list[str]:
    """A name as MediaPipe, VMC, Live Link Face and iFacialMocap spell it."""
    short = name.removesuffix("Left") + "_L" if name.endswith("Left") else name
    short = name.removesuffix("Right") + "_R" if name.endswith("Right") else short
    return [name, name[0].upper() + name[1:], name.lower(), short if name not in ("jawLeft", "mouthLeft") else name]


def test_there_are_the_52_of_arkit() -> None:
    assert len(set(ARKIT_NAMES)) == 52
    sides = {name.removesuffix("Left").removesuffix("Right") for name in ARKIT_NAMES}
    assert sides > {name.removesuffix("Left").removesuffix("Right") for name in ARKIT}


def test_each_is_found_by_every_spelling() -> None:
    found = {name: {ARKIT_CHANNELS.find(spelling) for spelling in spellings(name)} for name in ARKIT_NAMES}
    assert found == {name: {(name,)} for name in ARKIT_NAMES}


def test_no_two_are_spelled_alike() -> None:
    assert len({plain_spelling(name) for name in ARKIT_NAMES}) == 52
    assert not {plain_spelling(name) for name in ARKIT_NAMES} & set(ALIASES)


def test_a_cast_s_own_channels_are_found_too_and_what_it_lacks_is_not() -> None:
    names = ChannelNames(["jawOpen", "earUp_L", "eyeBlinkLeft"])
    assert names.find("JAWOPEN") == ("jawOpen",)
    assert names.find("earUpLeft") == ("earUp_L",)
    assert names.find("tongueOut") == ()
    assert names.find("Blink") == ("eyeBlinkLeft",)
    assert names.find("browInnerUpLeft") == ()
    assert names.find("") == ()


@pytest.mark.parametrize("name", ["eye blink left", "Eye_Blink_Left", " EYE-BLINK-L ", "eyeBlink.L", "eyeblink l"])
def test_signs_between_words_make_no_other_name(name: str) -> None:
    assert ARKIT_CHANNELS.find(name) == ("eyeBlinkLeft",)
    assert ChannelNames(["my_own", "eyeBlinkLeft"]).find("My own") == ("my_own",)


def test_vowels_of_vrm_shape_the_mouth_in_both_versions() -> None:
    for old, new in zip("AIUEO", ("aa", "ih", "ou", "ee", "oh"), strict=True):
        shares = ARKIT_CHANNELS.shares(old)
        assert shares == ARKIT_CHANNELS.shares(new)
        assert 0.0 < shares["jawOpen"] < 1.0
        assert set(shares) <= set(ARKIT_NAMES)
    assert ChannelNames(["a"]).shares("A") == {"a": 1.0}  # a channel of the cast comes first
