"""What expressions bring of blood and water, faders of the skin, and skins that no show wrote."""

from __future__ import annotations

from dataclasses import replace

import pytest

from omote.builtin import load_cast
from omote.model.space.complexion import PALE, Complexion
from omote.perform.complexion import (
    AS_IT_IS,
    RANGES,
    SKIN_FADERS,
    Skin,
    advance_skin,
    calm_skin,
    check_skin,
    complexion_of,
    fader_at,
    is_at_rest,
    set_skin,
    with_skin,
)
from omote.perform.frame import Frame

CRYING = Complexion(0.5, 1.0, 0.0, 1.0, 0.0, 1.0, 0.5)
STILL = Frame({"generic": 1.0}, {"neutral": 1.0})


def test_a_skin_at_rest_stays_as_it_is() -> None:
    assert advance_skin(AS_IT_IS, PALE, 1 / 60) is AS_IT_IS
    assert is_at_rest(AS_IT_IS)
    assert calm_skin(None) is None
    assert check_skin(None) is None


def test_each_number_stays_between_where_it_was_and_its_goal() -> None:
    skin = advance_skin(AS_IT_IS, CRYING, 1.0)
    for goal in (PALE, Complexion(-0.5), CRYING):
        later = advance_skin(skin, goal, 0.3)
        for before, now, wanted in zip(skin.second, later.second, goal, strict=True):
            low, high = sorted((before, wanted))
            assert low - 0.1 <= now <= high + 0.1  # what the first filter has ahead may still come
        assert check_skin(later) is later
        skin = later


def test_a_panic_leaves_nothing_even_where_an_expression_is_called_meanwhile() -> None:
    skin = calm_skin(advance_skin(AS_IT_IS, CRYING, 90.0))
    assert skin is not None
    assert with_skin(STILL, skin).complexion == CRYING
    skin = advance_skin(skin, CRYING, 0.2)
    assert 0.0 < with_skin(STILL, skin).complexion.nose < 0.2
    skin = advance_skin(skin, PALE, 0.1)
    assert with_skin(STILL, skin).complexion == PALE
    assert is_at_rest(skin)


@pytest.mark.parametrize(
    "wrong",
    [
        Skin({"pores": 1.0}),  # type: ignore[dict-item]
        Skin({"folds": 2.0}),
        Skin(second=Complexion(cheeks=float("nan"))),
        Skin(left=Complexion(tears=99.0)),
        Skin(folds=(1.0, -1.0)),
        Skin(drops=-1.0),
        Skin(released=9.0),
    ],
)
def test_a_skin_that_no_show_wrote_is_refused(wrong: Skin) -> None:
    with pytest.raises(ValueError, match=r"skin|complexion|sweat"):
        check_skin(wrong)


def test_faders_are_told_where_they_are_not_one() -> None:
    skin = set_skin(set_skin(None, "blood", 0.5), "folds", 1.0)
    assert dict(skin.faders) == {"blood": 0.5}
    assert (fader_at(skin, "blood"), fader_at(skin, "folds"), fader_at(None, "blood")) == (0.5, 1.0, 1.0)
    assert not is_at_rest(skin)
    assert replace(skin, faders={}) == AS_IT_IS


def test_a_region_brings_what_is_in_it() -> None:
    cast = load_cast()
    cry = cast.expressions["cry"].complexion
    frame = Frame({"generic": 1.0}, {"neutral": 1.0}, regions={"eyes": {"cry": 1.0}})
    assert complexion_of(cast.expressions, frame) == Complexion(eyes=cry.eyes, tears=cry.tears)
    frame = Frame({"generic": 1.0}, {"cry": 1.0}, regions={"eyes": {"neutral": 1.0}})
    assert complexion_of(cast.expressions, frame) == cry._replace(eyes=0.0, tears=0.0)


def test_channels_bring_theirs_and_the_sum_is_held() -> None:
    cast = load_cast()
    frame = Frame({"generic": 1.0}, {"shout": 1.0}, channels={"angry": 1.5, "cry": 1.5, "fear": -0.6})
    shown = complexion_of(cast.expressions, frame)
    low, high = (Complexion(*(ends[at] for ends in RANGES)) for at in (0, 1))
    assert (shown.cheeks, shown.tears, shown.sweat) == (high.cheeks, high.tears, low.sweat) == (1.4, 1.0, 0.0)
    pale = Frame({"generic": 1.0}, {"fear": 1.0}, channels={"fear": 1.5, "disgust": 1.5})
    assert complexion_of(cast.expressions, pale).whole == low.whole


@pytest.mark.parametrize("name", ["sweat", "tears", "", None])
def test_a_fader_that_there_is_not_is_refused(name: object) -> None:
    with pytest.raises(ValueError, match="there is no fader of the skin"):
        set_skin(None, name, 1.0)


@pytest.mark.parametrize("name", SKIN_FADERS)
def test_an_amount_beyond_its_range_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match=r"the amount of a fader of the skin is 1\.6"):
        set_skin(None, name, 1.6)
