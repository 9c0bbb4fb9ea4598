"""Labels of characters in cues: each place that names one takes them, and what nobody is called stays as written."""

from __future__ import annotations

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_action import CueAction
from omote.perform.cues.cue_names import named_cue
from omote.perform.cues.cue_player import CuePlayer
from omote.perform.scene.scene import Scene
from tests import synthetic

CAST = synthetic.cast()
FACE = tuple(CAST.faces)[1]
LABELS = {"one": "Anna", "two": "Big Rex"}


def test_parts_looks_framings_and_lines_are_of_the_character_of_the_label() -> None:
    moves = {
        "anna/face": Move({FACE: 1.0}),
        "Big Rex/look": Move({"character Anna": 1.0}),
        "*/framing": Move({"Big Rex+one": 1.0}),
        "Carl/face": Move({FACE: 1.0}),
    }
    actions = (CueAction("say", "ANNA", "Hello"), CueAction("say", "*", "All"), CueAction("say", "Carl", "No"))
    cue = named_cue(Cue("a", "1", moves, actions=actions), LABELS)
    assert {part: dict(move.goal) for part, move in cue.moves.items()} == {
        "one/face": {FACE: 1.0},
        "two/look": {"character one": 1.0},
        "*/framing": {"one+two": 1.0},
        "Carl/face": {FACE: 1.0},
    }
    assert [action.to for action in cue.actions] == ["one", "*", "Carl"]
    assert named_cue(cue, LABELS) is cue


def test_of_two_moves_of_one_part_none_is_dropped() -> None:
    for written in (("Anna/face", "one/face"), ("ANNA/face", "Anna/face")):
        cue = named_cue(Cue("a", "1", dict.fromkeys(written, Move({FACE: 1.0}))), LABELS)
        assert len(cue.moves) == 2
        assert "one/face" in cue.moves


def test_a_player_takes_labels_and_says_who_there_is_of_another() -> None:
    scene = Scene.begun(CAST)
    scene.rename("one", "Anna")
    player = CuePlayer(scene, [Cue("a", "1", {part: Move({FACE: 1.0}, 0.0) for part in ("Anna/face", "Carl/face")})])
    player.go()
    assert player.rejected == ("cue 1: there is no character 'Carl' in this scene, which has one (Anna)",)
    assert player.advance(0.0).characters["one"].frame.faces == {FACE: 1.0}
