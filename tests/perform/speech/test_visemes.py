"""The fifteen visemes: units, mixes, closures."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.cast import Cast
from omote.perform.blending.evaluate import evaluate
from omote.perform.performer import Performer
from omote.perform.speech.visemes import (
    AZURE,
    MOUTH_UNITS,
    PP,
    RECIPES,
    RHUBARB,
    VISEMES,
    check_viseme,
    mouth_of,
    shapes_of_azure,
    shapes_of_rhubarb,
    shapes_of_viseme,
    speech_frame,
)

JAW = MOUTH_UNITS.index("jawOpen")
CLOSE = MOUTH_UNITS.index("mouthClose")


@pytest.fixture(scope="module")
def built() -> Cast:
    """The built-in cast, whose lips have lines."""
    return omote.load_cast()


def _weights(**given: float) -> np.ndarray:
    return np.array([given.get(viseme, 0.0) for viseme in VISEMES])


def test_the_visemes_stand_in_the_order_of_oculus() -> None:
    """A tracker of OVRLipSync or OpenXR sends them in this order."""
    assert VISEMES == ("sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U")


def test_every_unit_is_a_channel_of_the_cast(built: Cast) -> None:
    """Nothing of a recipe is lost on the built-in cast."""
    assert set(MOUTH_UNITS) <= set(built.expressions)


def test_silence_and_nothing_at_all_are_a_mouth_at_rest() -> None:
    """Without weights the mouth is where it is without speech."""
    assert not mouth_of(_weights(sil=1.0)).any()
    assert not mouth_of(_weights()).any()


@pytest.mark.parametrize("viseme", VISEMES)
def test_only_shares_count(viseme: str) -> None:
    """A viseme of half the weight with nothing beside it is the same viseme."""
    assert np.allclose(mouth_of(_weights(**{viseme: 1.0})), mouth_of(_weights(**{viseme: 0.5})), atol=0.01)


@pytest.mark.parametrize("vowel", ["aa", "E", "I", "O", "U"])
def test_lips_close_beside_any_vowel_whatever_the_jaw_does(vowel: str) -> None:
    """A p of half the weight closes as far as the jaw has opened, and leaves nothing that parts lips."""
    mouth = dict(zip(MOUTH_UNITS, mouth_of(_weights(PP=0.5, **{vowel: 0.5})).tolist(), strict=True))
    assert mouth["mouthClose"] == mouth["jawOpen"] > 0.0
    assert mouth["mouthFunnel"] == mouth["mouthLowerDownLeft"] == mouth["tongueOut"] == 0.0
    assert mouth["mouthPressLeft"] == RECIPES["PP"]["mouthPressLeft"]


@pytest.mark.parametrize("vowel", ["aa", "E", "I", "O", "U"])
def test_the_lower_lip_meets_the_teeth_beside_any_vowel(vowel: str) -> None:
    """An f of half the weight has the jaw of an f, and its lip."""
    mouth = dict(zip(MOUTH_UNITS, mouth_of(_weights(FF=0.5, **{vowel: 0.5})).tolist(), strict=True))
    assert mouth["jawOpen"] == pytest.approx(RECIPES["FF"]["jawOpen"])
    assert mouth["mouthRollLower"] == RECIPES["FF"]["mouthRollLower"]


def test_rounding_goes_through_a_consonant_that_has_none() -> None:
    """The t of "stew" is spoken with the lips of its vowel (coarticulation)."""
    pucker = MOUTH_UNITS.index("mouthPucker")
    assert mouth_of(_weights(DD=0.5, U=0.5))[pucker] > 0.8 * RECIPES["U"]["mouthPucker"]


def test_a_mouth_is_continuous_in_its_weights() -> None:
    """From any viseme to any other no step is larger than its share of the way."""
    for one in range(len(VISEMES)):
        for other in range(len(VISEMES)):
            ways = [mouth_of(_between(one, other, share)) for share in np.linspace(0.0, 1.0, 201)]
            assert np.abs(np.diff(ways, axis=0)).max() < 0.05


def _between(one: int, other: int, share: float) -> np.ndarray:
    weights = np.zeros(len(VISEMES))
    weights[one] += 1.0 - share
    weights[other] += share
    return weights


def test_all_units_stay_in_their_range() -> None:
    """Whatever is mixed, no unit is negative or above one."""
    random = np.random.default_rng(7)
    for _ in range(500):
        mouth = mouth_of(random.random(len(VISEMES)) ** 4)
        assert mouth.min() >= 0.0
        assert mouth.max() <= 1.0


def test_a_frame_has_the_units_that_there_are() -> None:
    """A cast without a tongue speaks without one."""
    mouth = mouth_of(_weights(TH=1.0))
    frame = speech_frame(mouth, {"jawOpen": 0}, source="speech")
    assert frame.names == ("jawOpen",)
    assert frame.values.tolist() == [mouth[JAW]]
    assert (frame.source, frame.direct) == ("speech", True)


def test_lips_on_the_cast_close(built: Cast) -> None:
    """On every face, at the layer's influence of 0.7, a p beside an open vowel parts lips no farther than rest does."""
    lips = next(line for line in built.space.lines if line.kind == "lips")
    for face in ("generic", "dog"):
        gaps = []
        for weights in (_weights(sil=1.0), _weights(PP=0.6, aa=0.4), _weights(aa=1.0)):
            performer = Performer(built)
            performer.call_face(face, seconds=0.0)
            for unit, value in zip(MOUTH_UNITS, mouth_of(weights).tolist(), strict=True):
                performer.set_channel(unit, 0.7 * value)
            gaps.append(float(lips.rungs(evaluate(built, performer.advance(1.0)).astype(np.float64))[8:24, 1].mean()))
        rest, closed, opened = gaps
        assert closed < rest + 0.02 * (opened - rest)


def test_the_jaw_may_stay_open_behind_closed_lips() -> None:
    """Lips of a p are closed over the jaw of its neighbours."""
    mouth = mouth_of(_weights(PP=0.6, aa=0.4))
    assert mouth[JAW] > mouth_of(_weights(PP=1.0))[JAW]
    assert mouth[CLOSE] == mouth[JAW]
    assert VISEMES[PP] == "PP"


@pytest.mark.parametrize("wrong", ["pp", "viseme_PP", 3, None])
def test_rejects_a_viseme_that_there_is_not(wrong: object) -> None:
    """The message lists all of them."""
    with pytest.raises((ValueError, TypeError), match="viseme"):
        check_viseme(wrong)
    assert check_viseme("kk") == "kk"


def test_all_ids_of_azure_are_visemes_and_closures_stay_closures() -> None:
    assert len(AZURE) == 22
    assert {shape for shapes in AZURE for shape in shapes} <= set(VISEMES)
    assert (shapes_of_azure("0"), shapes_of_azure("21"), shapes_of_azure("18")) == (("sil",), ("PP",), ("FF",))
    assert shapes_of_azure("11") == ("aa", "I")


def test_shapes_of_rhubarb_and_spellings_of_oculus_are_visemes() -> None:
    assert {shape for shapes in RHUBARB.values() for shape in shapes} <= set(VISEMES)
    assert shapes_of_rhubarb("A") == ("PP",)
    assert [shapes_of_viseme(name) for name in ("viseme_PP", "pp", "ih", "oh", "ou", "KK", "aa")] == [
        ("PP",), ("PP",), ("I",), ("O",), ("U",), ("kk",), ("aa",),
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["22", "-1", "1.0", "", "²", "100", "a"])
def test_rejects_ids_that_azure_does_not_send(name: str) -> None:
    with pytest.raises(ValueError, match="give 0 to 21"):
        shapes_of_azure(name)


def test_rejects_shapes_and_visemes_that_there_are_not() -> None:
    with pytest.raises(ValueError, match="as Rhubarb writes"):
        shapes_of_rhubarb("a")
    with pytest.raises(ValueError, match="there is no viseme 'ZZ'"):
        shapes_of_viseme("ZZ")
