"""Doubts are sentences that know what ends them."""

import copy

from omote.model.fitting.doubt import EYES, PLACE, SHAPE, SIDES, Doubt, join_doubts

LOST = Doubt("Where is it?", PLACE)
ODD = Doubt("It is odd.")
ASKED = Doubt("Are its eyes shut?", EYES)


def test_a_doubt_is_its_sentence_and_keeps_its_kind() -> None:
    assert (LOST, LOST.kind, ODD.kind) == ("Where is it?", PLACE, SHAPE)
    assert copy.deepcopy(ASKED).kind == EYES


def test_doubts_come_once_and_in_order() -> None:
    assert join_doubts([LOST], [ODD, ASKED, LOST]) == (LOST, ODD, ASKED)
    assert join_doubts([], []) == ()


def test_of_sides_that_are_exchanged_nothing_else_is_asked() -> None:
    exchanged = Doubt("Left and right are exchanged.", SIDES)
    assert join_doubts([exchanged], [ODD, ASKED]) == (exchanged,)
