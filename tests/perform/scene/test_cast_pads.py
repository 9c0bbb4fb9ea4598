"""The pads that come with the cast."""

from __future__ import annotations

from omote.model.cast import Cast
from omote.perform.scene.cast_pads import FACES, MOODS, MOUTH, cast_pads


def test_neutral_is_in_the_middle_of_each_and_every_look_alone_at_its_place(cast: Cast) -> None:
    pads = cast_pads(cast)
    assert {name: pad.part for name, pad in pads.items()} == {
        "moods": "expression",
        "mouth": "mouth",
        "faces": "face",
    }
    for pad in pads.values():
        assert pad.mix_at((0.0, 0.0)) in ({"neutral": 1.0}, {"generic": 1.0})
        for look in pad.looks:
            assert pad.mix_at(look.place) == look.mix


def test_a_look_that_a_cast_lacks_is_left_out_and_a_pad_of_one_look_too(cast: Cast) -> None:
    for pad, layout in zip(cast_pads(cast).values(), (MOODS, MOUTH, FACES), strict=True):
        known = cast.faces if pad.part == "face" else cast.expressions
        assert [look.label for look in pad.looks] == [label for label, (_, of) in layout.items() if of in known]
    alone = Cast(cast.space, {"generic": cast.faces["generic"]}, cast.expressions)
    assert "faces" not in cast_pads(alone)
