"""Who did what: GO with the cue that it called, what followed by itself, and who edited which cue."""

from __future__ import annotations

from collections.abc import Sequence

from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.cues import DropCue, Go, GoToCue, PutCue, UndoCues
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello
from omote.show.recording.curves import CueCall, CurveSampler
from omote.show.recording.entries import AnyEntry, decode_entries, encode_entries
from omote.show.recording.recorder import Recorder
from omote.show.recording.show_log import tell_log
from omote.show.session import ShowSession
from omote.show.wire import encode
from tests import synthetic

CAST = synthetic.cast()


class Night:
    """A show that plays on, and what is recorded of it."""

    def __init__(self) -> None:
        self.session = ShowSession(CAST)
        self.now = 100.0
        for name in ("ana", "bo"):
            self.session.receive(name, Hello("console", PROTOCOL_VERSION, name), self.now)
        for number in "1234":
            self.session.receive("ana", PutCue(f"put-{number}", number=number), self.now)
        self.identities = self.session.cues.book.orders["main"]
        self.session.receive("ana", PutCue("goes", self.identities[1], goes_on="continue", post_wait=0.5), self.now)
        self.recorder = Recorder(self.session)
        self.sampler = CurveSampler()
        self.entries: list[AnyEntry] = []
        self.ticks = 0

    def play(self, seconds: float) -> None:
        for _ in range(round(60 * seconds)):
            self.now += 1 / 60
            self.ticks += 1
            state = self.session.tick(self.now)
            self.entries += self.recorder.take(0)
            if self.ticks % 6 == 0:
                self.sampler.note(self.now, encode(state), ())

    def log(self, calls: Sequence[CueCall] | None = None) -> list[tuple[str, str, str, int]]:
        """What is told of all that was recorded, as it comes from a file."""
        read = decode_entries(encode_entries(self.entries))
        found = self.sampler.take()[1] if calls is None else calls
        lines = tell_log(read, found, 0.0, self.now)
        assert lines == sorted(lines, key=lambda line: line.at)
        return [(line.who, line.what, line.of, line.times) for line in lines]


def test_each_go_is_told_with_its_cue_and_so_is_what_follows() -> None:
    """One that a page pressed, one of a program, which names no cue, one that comes too soon, and one out of order."""
    night = Night()
    night.play(0.1)
    night.session.receive("ana", Go("g1", seen=night.identities[0]), night.now)
    night.play(0.1)
    night.session.receive("bo", Go("g2", seen=night.identities[0]), night.now)
    night.play(1.0)
    night.session.receive("bo", Go("g3"), night.now)
    night.play(1.0)
    night.session.receive("bo", GoToCue("g4", "1", whole=True), night.now)
    night.play(1.0)
    assert night.log() == [
        ("ana", "go", "1", 1),
        ("bo", "go", "1 (nothing called)", 1),
        ("bo", "go", "2", 1),
        ("", "follow_cue", "3", 1),
        ("bo", "go_to_cue", "1 whole", 1),
    ]


def test_goes_are_told_one_by_one_and_a_fader_in_one_line() -> None:
    """Of an older recording too, which has no table of called cues."""
    night = Night()
    for press, identity in enumerate(night.identities[:2]):
        night.play(0.2)
        night.session.receive("ana", Go(f"g{press}", seen=identity), night.now)
        night.play(0.2)
    for value in range(5):
        night.session.receive("ana", SetChannel("one", "jawOpen", value / 5), night.now)
    night.play(0.1)
    assert night.log(calls=[]) == [
        ("ana", "go", "1", 1),
        ("ana", "go", "2", 1),
        ("ana", "set_channel", "one jawOpen", 5),
    ]


def test_who_edited_which_cue_is_told() -> None:
    night = Night()
    night.play(0.1)
    night.session.receive("bo", PutCue("p", night.identities[2], label="Night"), night.now)
    night.play(0.1)
    night.session.receive("ana", DropCue("d", night.identities[3]), night.now)
    night.session.receive("bo", UndoCues("u"), night.now)
    night.play(0.1)
    assert night.log() == [
        ("bo", "edit_cues", "change cue 3", 1),
        ("ana", "edit_cues", "delete cue 4", 1),
        ("bo", "edit_cues", "undo: delete cue 4", 1),
    ]


def test_a_cue_that_stood_when_the_show_began_did_not_follow() -> None:
    night = Night()
    night.session.receive("ana", Go("g1"), night.now)
    night.session.tick(night.now)
    night.recorder = Recorder(night.session)
    night.play(1.0)
    assert night.log() == []
