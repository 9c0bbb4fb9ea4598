"""Clips of a session: recorded while others play, edited, kept, and played by message."""

from __future__ import annotations

from typing import Any

import msgspec
import pytest

from omote.model.cast import Cast
from omote.show.clips import show_clips
from omote.show.declaration import Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import clips as wire
from omote.show.objects.calls import CallExpression, Panic
from omote.show.objects.characters import AddCharacter, RemoveCharacter
from omote.show.objects.link import Hello, Refused
from omote.show.session import ShowSession
from omote.showfile.changes import StoredDocument
from tests import synthetic
from tests.show.clips.clip_show import DT, Show, reason


def recorded(show: Show, name: str = "line1", seconds: float = 1.0, **channels: float) -> list[Outgoing]:
    show.send(wire.RecordClip, "one", name)
    show.set(**channels)
    show.run(seconds)
    show.set(**dict.fromkeys(channels, 0.0))
    return show.send(wire.KeepPass, "one")


def test_a_pass_is_recorded_kept_and_played_again(cast: Cast) -> None:
    show = Show(cast)
    told = recorded(show, jawOpen=0.5)
    assert [each.message for each in told] == [wire.Clips(["line1"])]
    assert show.session.clips.passes == {}
    show.send(wire.PlayClip, "one", "line1", seconds=0.0)
    assert [shown.get("jawOpen") for shown in show.run(0.5)] == [0.5] * 30
    assert show.playing() == ["line1"]
    show.session.receive("a", wire.StopClip("one", seconds=0.0), show.now)
    assert show.run(DT) == [{}]


def test_a_pass_of_one_part_is_recorded_while_the_others_play(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.5)
    show.send(wire.RecordClip, "one", "line1", ["brows"], "brows")
    assert show.playing() == ["line1"]
    show.run(1.5)
    show.send(wire.KeepPass, "one")
    clip = show.session.clips.clips["line1"]
    assert [(lane.name, lane.parts) for lane in clip.lanes][1] == ("brows", ("brows",))
    assert [clip.start, *(lane.start for lane in clip.lanes)] == [0.0, 0.0, 0.0]  # not a tick later
    assert [lane.stop for lane in clip.lanes] == pytest.approx([1.0, 1.5], abs=1e-9)
    assert clip.lanes[0].parts != clip.lanes[1].parts


def test_a_pass_of_a_span_begins_where_it_is_asked_for_with_the_others(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, seconds=2.0, jawOpen=0.5)
    show.send(wire.RecordClip, "one", "line1", ["brows"], "again", start=1.25)
    (playing,) = show.session.tick(show.now).characters["one"].clips
    assert playing.elapsed == pytest.approx(1.25 - show.session.clips.clips["line1"].start)
    show.run(0.5)
    show.send(wire.KeepPass, "one")
    lane = show.session.clips.clips["line1"].lanes[1]
    assert (lane.start, lane.stop) == pytest.approx((1.25, 1.75), abs=2 * DT)


def test_consoles_are_told_who_records_what_and_that_a_clip_has_changed(cast: Cast) -> None:
    show = Show(cast)

    def told() -> list[wire.ClipWork]:
        news = show.session.hands_now(show.now)
        return [each.message for each in news if isinstance(each.message, wire.ClipWork)]

    def welcomed() -> list[wire.ClipWork]:
        answers = show.session.receive("b", Hello("console", PROTOCOL_VERSION), show.now)
        show.session.leave("b")
        return [each.message for each in answers if isinstance(each.message, wire.ClipWork)]

    assert told() == welcomed() == []
    name = show.session.members["a"].name
    show.run(0.5)
    show.send(wire.RecordClip, "one", "line1", ["brows"], "mine")
    work = wire.ClipWork([wire.ClipPass("one", "line1", ["brows"], "mine", name, show.session.clock(show.now), 0.0)], 0)
    assert told() == [work] == welcomed()
    assert told() == []
    show.run(0.5)
    show.send(wire.KeepPass, "one")
    assert told() == [wire.ClipWork([], 1)] == welcomed()
    show.send(wire.EditLane, "line1", "1", weight=0.5)
    assert told() == [wire.ClipWork([], 2)]
    show.send(wire.RecordClip, "one", "line1")
    told()
    show.send(wire.KeepPass, "one", False)
    assert told() == [wire.ClipWork([], 2)]


def test_a_pass_that_is_forgotten_leaves_nothing(cast: Cast) -> None:
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1")
    show.run(0.5)
    assert show.send(wire.KeepPass, "one", False) == []
    assert (show.session.clips.clips, show.session.clips.passes) == ({}, {})


def test_a_pass_ends_by_itself_after_ten_minutes(cast: Cast, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(show_clips, "LONGEST_PASS", 0.5)
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1")
    show.run(1.0)
    assert show.session.clips.clips["line1"].seconds == pytest.approx(0.5, abs=2 * DT)
    assert wire.Clips(["line1"]) in [each.message for each in show.session.hands_now(show.now)]


def test_lanes_are_muted_mixed_shifted_and_replaced(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.5)
    recorded(show, jawOpen=1.0)
    assert [clip.weight for clip in show.session.clips.clips["line1"].lanes] == [1.0, 1.0]

    def shows(at: float) -> float:
        clip = show.session.clips.clips["line1"]
        sample = clip.sample(at)
        return float(sample.values[sample.layout.columns.index("channel/jawOpen")])

    assert shows(0.5) == 1.0
    show.send(wire.EditLane, "line1", "2", weight=0.5)
    assert shows(0.5) == 0.75
    show.send(wire.EditLane, "line1", "2", muted=True)
    assert shows(0.5) == 0.5
    show.send(wire.EditLane, "line1", "2", to="loud", muted=False, weight=1.0, shift=-2.0)
    assert shows(0.5) == 0.5
    show.send(wire.EditLane, "line1", "loud", shift=0.0)
    show.send(wire.ReplaceSpan, "line1", "1", "loud", 0.25, 0.75)
    assert [shows(at) for at in (0.2, 0.5, 0.8)] == [0.5, 1.0, 0.5]
    assert len(show.session.clips.clips["line1"].lanes) == 1
    assert "expected 1 to 16" in reason(show.send(wire.DropLane, "line1", "1"))
    show.send(wire.EditClip, "line1", start=0.25, stop=0.75, loop=True, speed=2.0, blend_in=0.1, blend_out=0.0)
    clip = show.session.clips.clips["line1"]
    assert (clip.seconds, clip.loop, clip.speed, clip.blend_in, clip.blend_out) == (0.5, True, 2.0, 0.1, 0.0)


def test_clips_are_renamed_copied_dropped_and_brought_back(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.5)
    clip = show.session.clips.clips["line1"]
    assert [each.message for each in show.send(wire.CopyClip, "line1", "line 2")] == [wire.Clips(["line 2", "line1"])]
    show.send(wire.RenameClip, "line1", "Line1")
    assert show.session.clips.clips == {"line 2": clip, "Line1": clip}
    show.send(wire.PlayClip, "one", "Line1")
    show.send(wire.DropClip, "Line1")
    assert show.playing() == ["Line1"]  # what plays goes on as it was called
    assert show.session.documents["clip"] == ["line 2"]
    show.send(wire.RestoreClip, "Line1")
    assert show.session.clips.clips == {"line 2": clip, "Line1": clip}


def test_the_show_file_follows_and_gives_the_same_clips_back(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.3)
    show.send(wire.CopyClip, "line1", "other")
    show.send(wire.EditLane, "line1", "1", weight=0.5, to="mouth", parts=["mouth", "brows"])
    changes = show.session.clips.take_changes()
    assert changes.keys() == {"line1", "other"}
    assert show.session.clips.take_changes() == {}
    bodies = {name: wire.stored_clip(clip).encode() for name, clip in changes.items() if clip is not None}
    clips, lost = wire.read_clips({**bodies, "damaged": b'{"lanes": []}'})
    assert lost == ["the clip damaged cannot be read (a clip has 0 lanes; expected 1 to 16) and is left out."]
    assert {name: wire.stored_clip(clip).encode() for name, clip in clips.items()} == bodies
    show.send(wire.DropClip, "other")
    assert show.session.clips.take_changes() == {"other": None}
    stored = msgspec.json.decode(bodies["line1"], type=wire.StoredClip)
    assert stored.names() == ["jawOpen"]
    assert len(StoredDocument("clip", "line1", bodies["line1"]).body) < 4000


def test_a_restarted_session_goes_on_with_its_clips(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.3)
    show.send(wire.PlayClip, "one", "line1", loop=True)
    show.run(0.4)
    again = Show(cast, ShowSession.restored(cast, show.session.snapshot(), epoch=2))
    assert again.playing() == []  # before the file is read nothing is known of it
    session = ShowSession.restored(cast, show.session.snapshot(), epoch=2)
    session.clips.load(show.session.clips.clips)
    assert [clip.name for clip in session.tick(0.0).characters["one"].clips] == ["line1"]


def test_a_panic_ends_clips(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.3)
    show.send(wire.PlayClip, "one", "line1", loop=True)
    show.run(0.4)
    show.send(Panic, "one")
    assert show.playing() == []
    assert show.run(0.5)[-1] == {}


def test_what_cannot_be_done_is_refused_and_changes_nothing(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.3)
    before = show.session.clips.clips
    show.send(CallExpression, "one", "smile")
    refused: dict[str, tuple[Any, ...]] = {
        "there is no clip 'line2' in this show": (wire.PlayClip, "one", "line2"),
        "the speed of a clip is 99": (wire.EditClip, "line1", None, None, None, None, None, 99.0),
        "no lane of this clip 'brows'": (wire.EditLane, "line1", "brows"),
        "cannot be replaced by itself": (wire.ReplaceSpan, "line1", "1", "1", 0.0, 1.0),
        "there is a clip 'line1' already": (wire.CopyClip, "line1", " LINE1 "),
        "a clip cannot be called": (wire.CopyClip, "line1", "\n"),
        "no pass of one is recorded": (wire.KeepPass, "one"),
        "there is no character 'two'": (wire.RecordClip, "two", "line2"),
        "where a pass begins (seconds of the clip) is 9": (wire.RecordClip, "one", "line1", [], "", "", 9.0),
        "no part of a clip": (wire.EditLane, "line1", "1", None, ["nose"]),
    }
    for said, (kind, *values) in refused.items():
        assert said in reason(show.send(kind, *values)), said
    show.send(wire.RecordClip, "one", "line2")
    assert "a pass of one is recorded already" in reason(show.send(wire.RecordClip, "one", "line3"))
    assert show.session.clips.clips == before


def test_a_pass_goes_on_through_a_change_of_the_cast_and_ticks_at_one_time(cast: Cast) -> None:
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1")
    show.run(0.5)
    show.session.recast(synthetic.Recast(cast, [*cast.faces], [*cast.expressions]))
    show.session.tick(show.now)
    show.run(0.5)
    assert reason_or_none(show.send(wire.KeepPass, "one")) is None
    assert show.session.clips.clips["line1"].seconds == pytest.approx(1.0, abs=2 * DT)


@pytest.mark.parametrize("after", [0.0, 0.5])
def test_who_leaves_in_a_pass_ends_it_and_costs_no_tick(cast: Cast, after: float) -> None:
    show = Show(cast)
    show.send(AddCharacter, "two", "Two", "generic")
    show.run(0.1)
    show.send(wire.RecordClip, "two", "line1")
    show.run(after)
    show.send(RemoveCharacter, "two", 0.0)
    show.run(0.2)
    assert show.session.clips.passes == {}
    assert [*show.session.clips.clips] == (["line1"] if after else [])


def test_a_pass_that_ends_by_itself_and_cannot_be_kept_is_told(cast: Cast, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(show_clips, "LONGEST_PASS", 0.3)
    monkeypatch.setattr(wire, "MOST_CLIPS", 0)
    show = Show(cast)
    show.send(wire.RecordClip, "one", "line1")
    show.run(1.0)
    assert show.session.clips.clips == {}
    (told,) = show.session.take_lost()
    assert "the pass of one" in told
    assert "0 clips" in told


def reason_or_none(answers: list[Outgoing]) -> str | None:
    refused = [answer.message.reason for answer in answers if isinstance(answer.message, Refused)]
    return refused[0] if refused else None


def heard(show: Show) -> list[tuple[str, float, str]]:
    state = show.session.tick(show.now).characters["one"]
    return [(clip.sound, clip.heard, clip.silent) for clip in state.clips]


def test_a_clip_is_recorded_along_with_a_sound_and_plays_it(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    show.send(wire.RecordClip, "one", "line1", sound="line")
    show.run(DT)
    speech = show.session.tick(show.now).characters["one"].speech
    assert speech is not None
    assert speech.sound == "line"
    assert speech.elapsed == pytest.approx(DT - 0.4)
    show.set(jawOpen=0.5)
    show.run(0.5)
    assert show.session.tick(show.now).characters["one"].channels["jawOpen"] == 0.5, "the lips are not taken"
    show.run(0.5)
    show.send(wire.KeepPass, "one")
    assert show.session.tick(show.now).characters["one"].speech is None
    clip = show.session.clips.clips["line1"]
    assert (clip.sound, clip.sound_at) == ("line", 0.4)
    show.send(wire.PlayClip, "one", "line1", start=0.5)
    show.run(0.25)
    ((sound, elapsed, silent),) = heard(show)
    assert (sound, silent) == ("line", "")
    assert elapsed == pytest.approx(clip.start + 0.35)
    show.session.receive("a", wire.StopClip("one"), show.now)
    assert heard(show) == [("", 0.0, "the clip is stopped")]


def test_a_pass_is_played_along_with_the_sound_of_its_clip_from_its_start(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    recorded(show, jawOpen=0.5)
    show.send(wire.EditClip, "line1", start=0.5, sound="line", sound_at=0.25)
    show.send(wire.RecordClip, "one", "line1", parts=["brows"])
    show.run(0.25)
    state = show.session.tick(show.now).characters["one"]
    assert state.speech is not None
    assert state.speech.elapsed == pytest.approx(0.5)
    assert [clip.heard for clip in state.clips] == [pytest.approx(0.5)], "a stage hears one sound of both"
    show.send(wire.KeepPass, "one")
    clip = show.session.clips.clips["line1"]
    assert (clip.sound, clip.sound_at, len(clip.lanes)) == ("line", 0.25, 2)


def test_a_sound_is_left_out_at_another_speed_and_begins_again_with_a_loop(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    recorded(show, jawOpen=0.5)
    show.send(wire.EditClip, "line1", sound="line", blend_in=0.0, stop=0.5)
    show.send(wire.PlayClip, "one", "line1", speed=0.5)
    assert heard(show) == [("", 0.0, "the clip plays at the speed 0.5, its sound at 1 alone")]
    show.send(wire.PlayClip, "one", "line1", seconds=0, loop=True)
    show.run(1.25)
    state = show.session.tick(show.now).characters["one"]
    clip = show.session.clips.clips["line1"]
    (playing,) = state.clips
    assert (playing.sound, playing.turn) == ("line", 2)
    assert playing.heard == pytest.approx(clip.start + 1.25 - 2 * clip.seconds)


def test_a_clip_whose_sound_is_gone_plays_without_and_says_so(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"line": 2.0})
    recorded(show, jawOpen=0.5)
    show.send(wire.EditClip, "line1", sound="line")
    show.session.set_sounds({})
    show.send(wire.PlayClip, "one", "line1")
    show.run(0.1)
    assert heard(show) == [("", 0.0, "its sound is not there any more")]
    show.send(wire.RecordClip, "one", "line1", parts=["brows"])
    assert "is recorded without its sound: there is no sound 'line'" in show.session.lost[-1]
    show.run(0.1)
    show.send(wire.KeepPass, "one")
    assert show.session.clips.clips["line1"].sound == "line"
    for kind, values in ((wire.RecordClip, ("one", "line2")), (wire.EditClip, ("line1",))):
        assert "there is no sound 'gong'" in reason(show.send(kind, *values, sound="gong"))
    show.session.set_sounds({"line": 2.0})
    show.send(wire.PlayClip, "one", "line1", seconds=0)
    show.run(2 * DT)
    show.send(wire.EditClip, "line1", sound="")
    assert [sound for sound, *_ in heard(show)] == ["line"], "what plays goes on as it was called"
    show.send(wire.PlayClip, "one", "line1", seconds=0)
    show.run(2 * DT)
    assert heard(show) == [("", 0.0, "")]


def test_a_clip_is_not_trimmed_to_beyond_its_lanes(cast: Cast) -> None:
    show = Show(cast)
    recorded(show, jawOpen=0.5)
    (lane,) = show.session.clips.clips["line1"].lanes
    for trim in ({"stop": 500.0}, {"start": 400.0}):
        (what,) = trim
        said = reason(show.send(wire.EditClip, "line1", **trim))
        assert said.startswith(
            f"the {what} of the clip line1 is {trim[what]:g} s, but its lanes end at {lane.stop:.3f}"
        )
    show.send(wire.EditClip, "line1", stop=lane.stop)
    assert show.session.clips.clips["line1"].end == lane.stop
