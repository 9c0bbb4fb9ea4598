"""Which stage plays sounds: one at a time."""

from __future__ import annotations

from omote.show.crew.members import SILENCE, Member
from omote.show.objects.stages import PlaysSound, SoundState, StageReport
from omote.show.speech.sound_stage import SoundStage


def _stage(sound: SoundState, *, here: bool = False, heard: float = 0.0) -> Member:
    return Member("stage", StageReport(60.0, "low", sound=sound, sound_here=here), heard)


def _told(stage: SoundStage, members: dict[str, Member], now: float = 0.0) -> list[tuple[str, bool]]:
    told = []
    for each in stage.tell(members, now):
        assert isinstance(each.message, PlaysSound)
        told.append((each.who, each.message.on))
    return told


def test_the_first_that_can_play_does_and_is_told_once() -> None:
    stage = SoundStage()
    members = {"a": _stage("blocked"), "b": _stage("ready"), "c": _stage("ready"), "d": _stage("")}
    assert _told(stage, members) == [("b", True)]
    assert _told(stage, members) == []


def test_one_whose_address_asks_for_it_goes_first_and_the_other_is_told_before() -> None:
    stage = SoundStage()
    assert _told(stage, {"a": _stage("ready")}) == [("a", True)]
    assert _told(stage, {"a": _stage("ready"), "b": _stage("blocked", here=True)}) == [("a", False), ("b", True)]


def test_the_one_that_plays_stays_while_it_is_as_good_as_others() -> None:
    stage = SoundStage()
    assert _told(stage, {"b": _stage("ready")}) == [("b", True)]
    assert _told(stage, {"a": _stage("ready"), "b": _stage("ready")}) == []


def test_another_takes_over_where_it_goes_or_is_silent() -> None:
    stage = SoundStage()
    both = {"a": _stage("ready"), "b": _stage("ready", heard=SILENCE + 1.0)}
    assert _told(stage, both) == [("a", True)]
    assert _told(stage, both, SILENCE + 1.0) == [("a", False), ("b", True)]
    assert _told(stage, {"a": both["a"]}) == [("a", True)]
    assert _told(stage, {}, 0.0) == []
    assert stage.who == ""


def test_consoles_and_stages_that_never_play_are_never_asked() -> None:
    stage = SoundStage()
    assert _told(stage, {"a": Member("console"), "b": Member("stage"), "c": _stage("")}) == []
