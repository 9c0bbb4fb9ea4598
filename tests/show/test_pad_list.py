"""What consoles are told of pads."""

from __future__ import annotations

from dataclasses import replace

from omote.model.cast import Cast
from omote.perform.pads.blend_space import Pad, PadLook
from omote.show.pad_list import AGAIN_SECONDS, PadListing, list_pads

PAD = Pad("p", "mouth", 1, (PadLook("A", {"smile": 1.0}, (0.0,)), PadLook("B", {"beam": 1.0}, (1.0,))))


def test_a_list_has_all_of_each_and_the_names_that_the_cast_lacks(cast: Cast) -> None:
    (told,) = list_pads({"p": PAD}, cast).pads
    assert (told.name, told.part, told.dimensions, tuple(told.looks)) == ("p", "mouth", 1, PAD.looks)
    assert told.missing == ["beam"]
    assert list_pads({"p": replace(PAD, part="face")}, cast).pads[0].missing == ["smile", "beam"]


def test_news_are_told_once_soon_and_not_too_often(cast: Cast) -> None:
    first: dict[str, Pad] = {}
    listing = PadListing(first, cast)
    assert listing.news(first, cast, 5.0) is None, "whoever is there was told at its welcome"
    second = {"p": PAD}
    assert listing.news(second, cast, 5.0) == list_pads(second, cast)
    third = dict(second)
    assert listing.news(third, cast, 5.0 + AGAIN_SECONDS / 2) is None
    assert listing.news(third, cast, 5.5) == list_pads(third, cast)
    other = cast.with_expressions(beam=cast.expressions["smile"])
    told = listing.news(third, other, 6.5)
    assert told is not None
    assert told.pads[0].missing == []
