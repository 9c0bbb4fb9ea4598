"""Cues and lists under way after a pad has another name: there and back, all is as it was."""

from __future__ import annotations

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_state import CueState, Step, Waiting
from omote.perform.cues.renamed_pads import cue_after_rename, moves_pad, state_after_rename

POINT = {":pad lips": 1.0, ":x": 0.5}
RENAMED = {":pad snout": 1.0, ":x": 0.5}
CUE = Cue("a", "1", {"one/mouth": Move(POINT, 2.0, delay=1.0), "one/eyes": Move({"smile": 1.0})}, label="lips")


def test_a_cue_moves_the_pad_by_its_new_name_and_all_else_of_it_stays() -> None:
    renamed = cue_after_rename(CUE, "lips", "snout")
    assert dict(renamed.moves) == {**CUE.moves, "one/mouth": Move(RENAMED, 2.0, delay=1.0)}
    assert (moves_pad(CUE, "lips"), moves_pad(renamed, "lips"), moves_pad(renamed, "snout")) == (True, False, True)
    assert cue_after_rename(renamed, "snout", "lips") == CUE
    assert cue_after_rename(CUE, "lip", "snout") is CUE


def test_a_list_tracks_waits_and_goes_back_by_the_new_name() -> None:
    step = Step("a", None, {"one/mouth": POINT, "one/eyes": None}, ("one/mouth",), {"one/mouth": POINT})
    waiting = Waiting("a", "one/mouth", CUE.moves["one/mouth"], 3.0)
    state = CueState("a", "b", {"one/mouth": POINT}, (waiting,), steps=(step,), clock=2.0)
    renamed = state_after_rename(state, "lips", "snout")
    assert renamed.tracked == {"one/mouth": RENAMED}
    assert [one.move.goal for one in renamed.waiting] == [RENAMED]
    assert (renamed.steps[0].stood, renamed.steps[0].before) == (
        {"one/mouth": RENAMED, "one/eyes": None},
        {"one/mouth": RENAMED},
    )
    assert state_after_rename(renamed, "snout", "lips") == state
