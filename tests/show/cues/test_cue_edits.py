"""Edits of cues: what is recorded of what shows, and what is refused in words (random ones: `test_cue_lists.py`)."""

from __future__ import annotations

from dataclasses import replace

import pytest

from omote.perform.cues.cue import Cue, Move
from omote.perform.cues.cue_action import CueAction
from omote.perform.limits import HEAD_LIMITS
from omote.show.cues.cue_edits import shown_goals
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import cues as wire
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from tests import synthetic

CAST = synthetic.cast()
FACE = tuple(CAST.faces)[1]
EXPRESSION = tuple(CAST.expressions)[-1]


@pytest.fixture
def session() -> ShowSession:
    session = ShowSession(CAST)
    session.receive("ana", Hello(role="console", version=PROTOCOL_VERSION, name="Ana"), 0.0)
    return session


def reason(session: ShowSession, message: wire.CueCommand) -> str:
    (answer,) = session.receive("ana", message, 0.0)
    assert isinstance(answer.message, Refused)
    return answer.message.reason


def test_the_first_cue_records_everything_and_each_after_it_what_is_otherwise(session: ShowSession) -> None:
    session.receive("ana", wire.RecordCue("a1", label="Curtain"), 0.0)
    session.scene["one"].call_face(FACE, seconds=0)
    session.receive("ana", wire.RecordCue("a2", seconds=3.0), 0.0)
    first, second = session.cues.book.cues.values()
    assert {"one/face", "one/head", "*/light", "*/black"} < first.moves.keys()
    assert "one/brows" not in first.moves  # it goes with its face
    assert {part: (dict(move.goal), move.seconds) for part, move in second.moves.items()} == {
        "one/face": ({FACE: 1.0}, 3.0)
    }
    assert (first.number, second.number) == ("1", "2")


def test_a_region_that_stands_by_itself_is_recorded_with_the_expression_that_would_take_it_along(
    session: ShowSession,
) -> None:
    """Two pads, a mouth left where it was: a GO of the mood's cue took it along, and the mouth was lost."""
    one = session.scene["one"]
    others = list(CAST.expressions)
    one.call_expression(others[1], seconds=0.0)
    one.call_expression(others[2], seconds=0.0, region="mouth")
    session.receive("ana", wire.RecordCue("a1"), 0.0)
    one.call_expression(others[3], seconds=0.0)
    one.call_expression(others[2], seconds=0.0, region="mouth")
    session.receive("ana", wire.RecordCue("a2"), 0.0)
    _, second = session.cues.book.cues.values()
    assert {part: dict(move.goal) for part, move in second.moves.items()} == {
        "one/expression": {others[3]: 1.0},
        "one/mouth": {others[2]: 1.0},
    }


def test_cues_that_are_recorded_one_after_another_stand_in_that_order_behind_the_one_called_last(
    session: ShowSession,
) -> None:
    """Each stood directly behind the one called last, in front of those recorded before it."""
    one = session.scene["one"]
    for number, name in enumerate(list(CAST.expressions)[1:6]):
        one.call_expression(name, seconds=0.0)
        session.receive("ana", wire.RecordCue(f"a{number}", label=name), 0.0)
        if number == 1:
            session.receive("ana", wire.GoToCue("g", "2"), 1.0)
    order = session.cues.book.orders["main"]
    assert [session.cues.book.cues[cue].label for cue in order] == list(CAST.expressions)[1:6]


def test_parts_that_are_named_are_recorded_alone(session: ShowSession) -> None:
    session.receive("ana", wire.RecordCue("a1", parts=["*/light", "one"]), 0.0)
    (cue,) = session.cues.book.cues.values()
    assert {part.rpartition("/")[0] for part in cue.moves} == {"one", "*"}
    assert [part for part in cue.moves if part.startswith("*")] == ["*/light"]
    assert "there is no part 'one/nose'" in reason(session, wire.RecordCue("a2", parts=["one/nose"]))


def test_a_record_that_finds_nothing_is_refused(session: ShowSession) -> None:
    session.receive("ana", wire.RecordCue("a1"), 0.0)
    assert "nothing to record" in reason(session, wire.RecordCue("a2"))
    assert len(session.cues.book.cues) == 1


def test_a_cue_of_all_of_a_character_brings_all_of_it_back_whatever_was_played_since(session: ShowSession) -> None:
    """Also what is as in a new show, which a preset is recorded from; regions go with the whole expression."""
    session.receive("ana", wire.RecordCue("a1", parts=["one"]), 0.0)
    (preset,) = session.cues.book.cues.values()
    assert not [part for part in preset.moves if part.rpartition("/")[2] in ("brows", "eyes", "mouth", "rest")]
    begun = {part: goal for part, goal in shown_goals(session.scene).items() if part.startswith("one/")}
    one = session.scene["one"]
    one.look_at("direction", yaw=0.25)
    one.set_layer("tracker", influence=0.5)
    for part, goal in (("face", {FACE: 1.0}), ("brows", {EXPRESSION: 1.0}), ("presence", {"presence": 0.5})):
        session.scene.call_goal(f"one/{part}", goal, seconds=0.0)
    session.scene.call_goal("one/head", {"yaw": 0.1, "pitch": 0.2, "roll": 0.3}, seconds=0.0)
    session.receive("ana", wire.Go("b1"), 1.0)
    for tick in range(120):
        session.tick(1.0 + tick / 60.0)
    assert {part: goal for part, goal in shown_goals(session.scene).items() if part.startswith("one/")} == begun


def test_numbers_are_recorded_with_four_decimals_and_within_their_ranges(session: ShowSession) -> None:
    """What is recorded stands there then: an update finds nothing else."""
    highest = dict(HEAD_LIMITS)
    for call, goal in (("a1", {"yaw": 0.349065850398, "pitch": -0.1000000001, "roll": 0.0}), ("a2", highest)):
        session.scene.call_goal("one/head", goal, seconds=0.0)
        session.receive("ana", wire.RecordCue(call), 0.0)
    first, second = session.cues.book.cues_of("main")
    assert first.moves["one/head"].goal == {"yaw": 0.3491, "pitch": -0.1, "roll": 0.0}
    assert second.moves["one/head"].goal == pytest.approx(highest, abs=1e-4)
    session.receive("ana", wire.UpdateCue("a3", second.identity), 0.0)
    assert session.cues.book.cues[second.identity] == second


def test_characters_are_called_by_their_labels_in_every_edit(session: ShowSession) -> None:
    """Also in a text that is taken in, and in a show file of one; nobody of a label is refused with all that are."""
    session.scene.rename("one", "Anna")
    session.receive("ana", wire.RecordCue("a1", parts=["Anna", "*/light"]), 0.0)
    (identity,) = session.cues.book.cues
    session.receive("ana", wire.PutMove("a2", identity, "anna/face", {FACE: 1.0}), 0.0)
    session.receive("ana", wire.PutCue("a3", identity, actions=[CueAction("say", "Anna", "Hello")]), 0.0)
    cue = session.cues.book.cues[identity]
    assert {part.rpartition("/")[0] for part in cue.moves} == {"one", "*"}
    assert (cue.moves["one/face"].goal, cue.actions[0].to) == ({FACE: 1.0}, "one")
    session.receive("ana", wire.DropMove("a4", identity, "Anna/face"), 0.0)
    assert "one/face" not in session.cues.book.cues[identity].moves
    taken = Cue("b", "1", {"Anna/face": Move({FACE: 1.0})})
    session.cues.take_in("other", [taken], "a file")
    session.cues.load(
        replace(
            session.cues.book,
            cues={**session.cues.book.cues, identity: replace(cue, moves={"Anna/face": Move({FACE: 1.0})})},
        )
    )
    assert [list(cue.moves) for cue in session.cues.book.cues.values()] == [["one/face"]] * 2
    assert "there is no character 'Carl' in this scene, which has one (Anna)" in reason(
        session, wire.RecordCue("a5", parts=["Carl"])
    )


def test_moves_stand_character_by_character_in_the_order_of_the_show(session: ShowSession) -> None:
    session.scene.add("aki")
    session.receive("ana", wire.PutCue("a1", number="1"), 0.0)
    (identity,) = session.cues.book.cues
    goals = {"aki/face": {FACE: 1.0}, "*/black": {"black": 1.0}, "one/brows": {}, "one/expression": {EXPRESSION: 1.0}}
    for call, (part, goal) in enumerate(goals.items()):
        session.receive("ana", wire.PutMove(f"b{call}", identity, part, goal), 0.0)
    assert list(session.cues.book.cues[identity].moves) == ["one/expression", "one/brows", "aki/face", "*/black"]


def test_what_eyes_look_at_and_how_much_of_a_layer_shows_are_recorded_and_tracked(session: ShowSession) -> None:
    """What a new show has is left out of a first recording, and written where a cue before has left it otherwise."""
    one = session.scene["one"]
    session.receive("ana", wire.RecordCue("a1"), 0.0)
    one.look_at("direction", yaw=0.25)
    one.set_layer("tracker", influence=0.5)
    session.receive("ana", wire.RecordCue("a2"), 0.0)
    one.look_at("ahead")
    one.set_layer("tracker", influence=1.0)
    session.receive("ana", wire.RecordCue("a3"), 0.0)
    first, second, third = session.cues.book.cues_of("main")
    assert not [part for part in first.moves if part.endswith("/look") or "layer:" in part]
    goals = [{part: dict(move.goal) for part, move in cue.moves.items()} for cue in (second, third)]
    regions = ("brows", "eyes", "mouth", "rest", "head", "gaze")
    assert goals == [
        {"one/layer:tracker": dict.fromkeys(regions, 0.5), "one/look": {"yaw": 0.25, "pitch": 0.0}},
        {"one/layer:tracker": dict.fromkeys(regions, 1.0), "one/look": {"ahead": 1.0}},
    ]
    for call, cue in (("b1", "2"), ("b2", "3")):
        session.receive("ana", wire.GoToCue(call, cue, whole=True), 1.0 + float(cue))
        session.tick(1.0 + float(cue))
    session.receive("ana", wire.GoBack("b3"), 9.0)
    assert session.scene.goal_of("one/look") == {"yaw": 0.25, "pitch": 0.0}
    assert session.scene.goal_of("one/layer:tracker") == dict.fromkeys(regions, 0.5)


def test_an_update_writes_what_was_moved_by_hand_into_the_cue_that_was_called(session: ShowSession) -> None:
    session.receive("ana", wire.RecordCue("a1"), 0.0)
    assert "no cue has been called that could be updated" in reason(session, wire.UpdateCue("a2"))
    session.receive("ana", wire.Go("a3"), 1.0)
    session.scene["one"].set_head(yaw=0.3, pitch=0.0, roll=0.0)
    session.receive("ana", wire.UpdateCue("a4"), 2.0)
    (cue,) = session.cues.book.cues.values()
    assert cue.moves["one/head"].goal["yaw"] == 0.3
    session.receive("ana", wire.UndoCues("a5"), 2.0)
    (cue,) = session.cues.book.cues.values()
    assert cue.moves["one/head"].goal["yaw"] == 0.0


def test_while_the_show_mode_is_on_nobody_edits(session: ShowSession) -> None:
    session.receive("ana", wire.RecordCue("a1"), 0.0)
    session.receive("ana", wire.SetShowMode("a2", on=True), 0.0)
    assert "the show mode is on" in reason(session, wire.RecordCue("a3"))
    assert "the show mode is on" in reason(session, wire.UndoCues("a4"))
    assert session.receive("ana", wire.Go("a5"), 1.0) == []


@pytest.mark.parametrize(
    ("message", "said"),
    [
        (wire.PutMove("b", "0-0", "one/nose", {"nose": 1.0}), "there is no part 'one/nose'"),
        (wire.PutMove("b", "0-0", "one/face", {FACE: 0.5}), "the weights of one/face sum to 0.5"),
        (wire.PutMove("b", "gone", "one/face", {FACE: 1.0}), "somebody has deleted it"),
        (wire.PutCue("b", number="1"), "two cues have the number 1"),
        (wire.PutCue("b", number="1.2.3"), "a cue cannot be numbered '1.2.3'"),
        (wire.PutCue("b", after="gone"), "there is no cue of this list 'gone'"),
        (wire.DropMove("b", "0-0", "one/place"), "there is no part of this cue 'one/place'"),
        (wire.AddCueList("b", "MAIN"), "there is a list of cues 'MAIN' already"),
        (wire.AddCueList("b", "  "), "a list of cues cannot be called"),
        (wire.DropCueList("b", "main"), "a show has 1 to 16 lists of cues, not 0"),
        (wire.RedoCues("b"), "no edit of cues to do again"),
    ],
)
def test_an_edit_that_cannot_be_made_says_why_and_changes_nothing(
    session: ShowSession, message: wire.CueCommand, said: str
) -> None:
    session.receive("ana", wire.PutCue("a", number="1"), 0.0)
    book = session.cues.book
    assert said in reason(session, message)
    assert session.cues.book is book
