"""The sounds that a show keeps: named, renamed, deleted and brought back; clips, cues and speeches find them."""

from __future__ import annotations

from typing import Any

import pytest

from omote.model.cast import Cast
from omote.perform.cues.cue_action import CueAction
from omote.show.declaration import ClientMessage, ServerMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects import clips as clip_messages
from omote.show.objects.cues import Go, PutCue
from omote.show.objects.link import Hello, Refused
from omote.show.objects.sounds import (
    DropSound,
    NamedSound,
    RenameSound,
    RestoreSound,
    SoundDropped,
    Sounds,
    StoredSound,
)
from omote.show.objects.speech import Say
from omote.show.session import ShowSession
from omote.show.speech import named_sounds
from omote.show.speech.named_sounds import NamedSounds, read_sounds

DT = 1.0 / 60.0
LINE = StoredSound("5" * 32, 2.0, "c1", 100)
BELL = StoredSound("b" * 32, 1.0, "c2", 50)


class Show:
    """A session with one console, its clock, and the sound `line 1`."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.now = 0.0
        self.calls = 0
        self.session.receive("a", Hello("console", PROTOCOL_VERSION), 0.0)
        self.session.named_sounds.load({"line 1": LINE})
        self.run(DT)

    def send(self, kind: type[ClientMessage], *values: Any, **named: Any) -> list[ServerMessage]:
        self.calls += 1
        message = kind(*(f"{self.calls}" if value is None else value for value in values), **named)
        return [answer.message for answer in self.session.receive("a", message, self.now)]

    def run(self, seconds: float) -> None:
        for _ in range(round(seconds / DT)):
            self.now += DT
            self.session.tick(self.now)

    def told(self) -> list[ServerMessage]:
        return [each.message for each in self.session.hands_now(self.now)]

    def heard(self) -> tuple[str, str]:
        """The key of what is said, and why the clip that plays is silent."""
        state = self.session.tick(self.now).characters["one"]
        return "" if state.speech is None else state.speech.sound, "".join(clip.silent for clip in state.clips)


def test_a_speech_a_cue_and_a_clip_find_a_sound_by_its_name_of_now_of_before_and_by_its_key(cast: Cast) -> None:
    show = Show(cast)
    show.send(RenameSound, None, "line 1", "Opening")
    assert Sounds([NamedSound("Opening", LINE.sound, 2.0, ["line 1"])]) in show.told()
    for called in ("Opening", "line 1", LINE.sound):
        show.send(Say, "one", None, "Good evening", sound=called)
        assert show.heard() == (LINE.sound, "")
    show.send(PutCue, None, actions=[CueAction("say", "one", "", sound="line 1")])
    show.send(Go, None)
    show.run(1.0)
    assert show.heard() == (LINE.sound, "")
    show.send(clip_messages.RecordClip, None, "one", "mono", sound="Opening")
    show.run(1.0)
    show.send(clip_messages.KeepPass, None, "one")
    assert show.session.clips.clips["mono"].sound == "Opening"
    show.send(clip_messages.PlayClip, "one", None, "mono")
    show.run(0.5)
    ((sound, elapsed),) = [(clip.sound, clip.heard) for clip in show.session.tick(show.now).characters["one"].clips]
    assert (sound, elapsed > 0.0) == (LINE.sound, True)


def test_a_sound_that_is_deleted_says_who_needs_it_is_silent_and_comes_back(cast: Cast) -> None:
    show = Show(cast)
    show.send(PutCue, None, actions=[CueAction("say", "one", "", sound="line 1")])
    show.send(clip_messages.RecordClip, None, "one", "mono", sound="line 1")
    show.run(1.0)
    show.send(clip_messages.KeepPass, None, "one")
    show.send(RenameSound, None, "line 1", "Opening")
    assert show.send(DropSound, None, "Opening") == [SoundDropped("Opening", ["the clip mono", "the cue 1 of main"])]
    assert Sounds([]) in show.told()
    show.send(clip_messages.PlayClip, "one", None, "mono")
    show.run(0.2)
    assert show.heard() == ("", "its sound is not there any more")
    show.send(Go, None)
    show.run(0.2)
    status = show.session.tick(show.now).cues
    assert status is not None
    assert "there is no sound 'line 1'" in status.rejected[-1]
    show.send(RestoreSound, None, "Opening")
    assert show.session.named_sounds.sounds["Opening"].former == ("line 1",)
    show.run(0.2)
    assert show.heard() == ("", "")


def test_a_console_that_comes_later_is_told_of_the_sounds(cast: Cast) -> None:
    show = Show(cast)
    told = show.session.receive("b", Hello("console", PROTOCOL_VERSION), 0.0)
    assert Sounds([NamedSound("line 1", LINE.sound, 2.0)]) in [each.message for each in told]


def test_what_a_program_sent_stays_beside_what_is_kept(cast: Cast) -> None:
    show = Show(cast)
    show.session.set_sounds({"sent": 1.5})
    assert show.session.sounds.seconds() == {"sent": 1.5, LINE.sound: 2.0}
    show.send(DropSound, None, "line 1")
    assert show.session.sounds.seconds() == {"sent": 1.5}


@pytest.mark.parametrize("name", ["", "  ", "x" * 61, "a\nb\x00", "0" * 32])
def test_a_name_that_is_none_is_refused(name: str) -> None:
    with pytest.raises(ValueError, match="a sound cannot be called"):
        NamedSounds().add(name, LINE)


def test_names_are_free_in_any_case_and_a_new_take_replaces_the_one_before() -> None:
    sounds = NamedSounds()
    assert sounds.add(" line  1 ", LINE) == "line 1"
    with pytest.raises(ValueError, match="a sound 'line 1' already; give another name, or replace it"):
        sounds.add("line 1", BELL)
    with pytest.raises(ValueError, match="a sound 'line 1' already"):
        sounds.add("Line 1", BELL, replace=True)
    sounds.add("bell", BELL)
    with pytest.raises(ValueError, match="a sound 'bell' already"):
        sounds.rename("line 1", "Bell")
    sounds.rename("line 1", "Line 1")
    sounds.add("Line 1", BELL, replace=True)
    assert sounds.called() == {"line 1": BELL.sound, "Line 1": BELL.sound, "bell": BELL.sound}
    assert sounds.dropped["Line 1"].sound == LINE.sound


def test_no_more_sounds_than_there_is_room_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(named_sounds, "MOST_NAMED_BYTES", 120)
    sounds = NamedSounds()
    sounds.add("line", LINE)
    with pytest.raises(ValueError, match="120 bytes at most: 100 are taken, and this one has 50; send it as MP3"):
        sounds.add("bell", BELL)
    sounds.add("line", BELL, replace=True)
    monkeypatch.setattr(named_sounds, "MOST_NAMED_SOUNDS", 1)
    with pytest.raises(ValueError, match="there are 1 sounds, which is as many as a show keeps"):
        sounds.add("other", BELL)
    assert not isinstance(sounds.message(), Refused)


def test_a_sound_that_cannot_be_read_costs_itself() -> None:
    lost = {"a": LINE.encode(), "damaged": b"{}", "empty": BELL.encode()}
    sounds, told = read_sounds(lost, {"c1"})
    assert sounds == {"a": LINE}
    assert [" ".join(sentence.split()[:3]) for sentence in told] == ["the sound damaged", "the sound empty"]
