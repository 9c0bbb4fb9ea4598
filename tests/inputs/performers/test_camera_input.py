"""Performers before cameras at a session: a source each, routed, calibrated, stored, displaced by a second page."""

from collections.abc import Mapping

import pytest

from omote.inputs.performers import camera_messages as wire
from omote.inputs.performers.camera_input import MOST_CAMERAS, MOST_LEFT, CameraInput
from omote.inputs.performers.performer_list import PerformerList
from omote.inputs.trackers.tracker_input import TrackerInput
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.inputs.trackers.vmc_messages import encode_vmc
from omote.model.cast import Cast
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello
from omote.show.objects.state import State
from omote.show.session import ShowSession
from omote.show.sources.open_sources import QUIET_SECONDS
from tests.inputs.performers.landmarks import packet

TICK = 1.0 / 60.0


class Stage:
    """A session, its cameras, a show file's performers, and a clock."""

    def __init__(self, cast: Cast) -> None:
        self.session = ShowSession(cast)
        self.now = 0.0
        self.stored: dict[str, bytes] = {}
        self.cameras = self.open()
        self.session.receive("console", Hello("console", PROTOCOL_VERSION, "console"), 0.0)

    def open(self) -> CameraInput:
        return CameraInput(lambda: self.session, PerformerList(dict(self.stored), self._keep))

    def _keep(self, documents: Mapping[str, bytes], gone: list[str]) -> None:
        for name in gone:
            del self.stored[name]
        self.stored.update(documents)

    def begin(self, link: str = "1", name: str = "Ada") -> str | None:
        return self.cameras.obey(link, wire.Perform(wire.CAMERA_VERSION, name))

    def play(self, seconds: float, link: str = "1", **face: float | bool) -> State:
        for count in range(max(1, round(seconds / TICK))):
            if count % 2 == 0:
                self.cameras.receive(link, packet(self.now, **face))  # type: ignore[arg-type]
            self.cameras.play(self.now)
            for each, fit in self.cameras.take_fits():
                self.cameras.receive_fit(each, fit, fit.fit())
            self.now += TICK
            state = self.session.tick(self.now)
        return state

    def status(self, link: str = "1") -> wire.CameraStatus:
        status = self.cameras.status(link)
        assert status is not None
        return status

    def jaw(self, character: str = "one") -> float:
        return self.session.tick(self.now).characters[character].layers["tracker"].strongest.get("jawOpen", 0.0)

    def sources(self) -> list[str]:
        return [each.name for each in self.session.sources.states({})]


@pytest.fixture
def stage(cast: Cast) -> Stage:
    return Stage(cast)


def test_a_camera_plays_the_only_character_when_another_tracker_is_silent(stage: Stage) -> None:
    vmc = TrackerInput(TRACKER_PROTOCOLS["vmc"], lambda: stage.session)
    for packet_of_vmc in encode_vmc({"jawOpen": 0.5}, (0.1, 0.0, 0.0), (0.0, 0.0), 0.0):
        vmc.receive("10.0.0.7", packet_of_vmc, stage.now)
    vmc.play(stage.now)
    for _ in range(round(QUIET_SECONDS) + 2):
        stage.now += 1.0
        stage.session.hands_now(stage.now)
    stage.begin()
    stage.play(3.0)
    assert [(each.name, each.characters) for each in stage.session.sources.states({})] == [
        ("VMC 10.0.0.7", ["one"]),
        ("Camera Ada", ["one"]),
    ]


def test_a_performer_at_rest_for_two_seconds_drives_the_only_character(stage: Stage) -> None:
    stage.begin()
    assert stage.status().calibrated == "no"
    stage.play(2.2)
    assert stage.status().calibrated == "rest"
    stage.play(2.0, jaw=0.06)
    assert stage.sources() == ["Camera Ada"]
    assert stage.session.tick(stage.now).characters["one"].layers["tracker"].source == "Camera Ada"
    assert stage.jaw() > 0.2
    assert [(each.name, each.played) for each in stage.status().characters] == [("one", True)]


def test_a_performer_who_comes_again_is_known_at_once(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.cameras.end("1")
    assert stage.sources() == []
    stage.cameras = stage.open()  # the next server
    stage.begin()
    assert (stage.status().calibrated, stage.status().performers) == ("rest", ["Ada"])
    stage.play(1.0, jaw=0.06)
    assert stage.jaw() > 0.2


def test_what_is_stored_and_cannot_be_read_counts_as_unknown(stage: Stage) -> None:
    stage.stored["Ada"] = b'{"calibration":{"version":99},"guided":true}'
    stage.cameras = stage.open()
    stage.begin()
    assert (stage.status().calibrated, stage.status().performers) == ("no", ["Ada"])


def test_the_guided_minute_is_stored_as_such(stage: Stage) -> None:
    stage.begin()
    stage.cameras.obey("1", wire.BeginGuide())
    stage.play(70.0)
    assert (stage.status().calibrated, stage.status().guide) == ("guided", None)
    assert b'"guided":true' in stage.stored["Ada"]
    stage.cameras.obey("1", wire.RedoStep("puff"))
    guide = stage.status().guide
    assert guide is not None
    assert guide.step == "puff"
    stage.cameras.obey("1", wire.CancelGuide())
    assert stage.status().guide is None


def test_a_guided_minute_that_is_ended_goes_on_or_is_used_as_far_as_it_is_made(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.cameras.obey("1", wire.BeginGuide())
    stage.play(12.0)
    stage.cameras.obey("1", wire.CancelGuide())
    stage.play(0.1)
    status = stage.status()
    assert (status.guide, status.calibrated, status.unused) == (None, "rest", True)
    stage.cameras.obey("1", wire.ContinueGuide())
    guide = stage.status().guide
    assert guide is not None
    assert guide.step == status.missing[0]
    stage.cameras.obey("1", wire.RenamePerformer("Bea"))
    assert (stage.status().performer, stage.status().missing, stage.status().unused) == ("Bea", status.missing, True)
    stage.cameras.obey("1", wire.UseFaces())
    stage.play(0.1)
    used = stage.status()
    assert (used.calibrated, used.unused, used.missing) == ("guided", False, status.missing)


def test_faces_that_are_not_used_yet_wait_for_a_page_that_loads_again_or_for_the_name(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.cameras.obey("1", wire.BeginGuide())
    stage.play(12.0)
    missing = stage.status().missing
    stage.cameras.end("1")
    stage.begin("2")  # the page has loaded again, in the middle of its minute
    assert (stage.status("2").missing, stage.status("2").unused, stage.status("2").guide) == (missing, True, None)
    stage.begin("2", "Bo")  # somebody else plays, and then the first one
    assert (stage.status("2").redoable, stage.status("2").unused) == ([], False)
    stage.begin("2")
    assert (stage.status("2").missing, stage.status("2").unused) == (missing, True)
    stage.begin("3")  # a second page takes over
    assert (stage.status("3").missing, stage.status("3").unused) == (missing, True)
    stage.cameras.obey("3", wire.DeletePerformer())
    assert (stage.status("3").redoable, stage.status("3").unused) == ([], False)
    stage.cameras.end("3")
    stage.begin("4")
    assert stage.status("4").redoable == []


def test_faces_of_few_who_left_are_kept(stage: Stage) -> None:
    for name in ("Ada", "Bo", "Cy", "Di", "Ed"):
        stage.begin("1", name)
        stage.cameras.obey("1", wire.BeginGuide())
        stage.play(4.5)
        assert stage.status().redoable
    assert MOST_LEFT == 4
    stage.cameras.end("1")
    kept = []
    for name in ("Ada", "Bo", "Ed"):
        stage.begin("1", name)
        kept.append(bool(stage.status().redoable))
    assert kept == [False, True, True]


def test_a_fit_that_fails_leaves_what_was(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.cameras.obey("1", wire.BeginGuide(rest=True))
    for count in range(200):
        stage.now += TICK
        stage.cameras.receive("1", packet(count * TICK))
        stage.cameras.play(stage.now)
    ((link, fit),) = stage.cameras.take_fits()
    before = dict(stage.stored)
    stage.cameras.receive_fit(link, fit, None)
    assert (stage.status().fitting, stage.status().calibrated, stage.stored) == (False, "rest", before)


def test_a_page_chooses_whom_it_plays_before_and_after_its_first_frame(stage: Stage) -> None:
    stage.session.receive("console", AddCharacter("a", "two", "Two", "broad"), 0.0)
    stage.begin()
    stage.cameras.obey("1", wire.PlayCharacters(["two"]))
    assert [each.played for each in stage.status().characters] == [False, True]
    stage.play(2.3)
    stage.play(1.0, jaw=0.06)
    assert stage.jaw("two") > 0.2
    assert "tracker" not in stage.session.tick(stage.now).characters["one"].layers
    stage.cameras.obey("1", wire.PlayCharacters([]))
    stage.play(0.1)
    assert not any(each.played for each in stage.status().characters)


def test_a_performer_is_renamed_and_deleted_and_both_are_undone(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.cameras.obey("1", wire.RenamePerformer("Bo"))
    assert (stage.status().performer, stage.status().calibrated) == ("Bo", "rest")
    stage.play(0.2)
    assert stage.sources() == ["Camera Bo"]
    stage.cameras.obey("1", wire.UndoPerformer())
    assert (stage.status().performer, list(stage.stored)) == ("Ada", ["Ada"])
    stage.cameras.obey("1", wire.DeletePerformer())
    assert (stage.status().calibrated, stage.stored) == ("no", {})
    stage.cameras.obey("1", wire.UndoPerformer())
    assert (stage.status().calibrated, list(stage.stored)) == ("rest", ["Ada"])


def test_a_second_page_of_the_same_performer_takes_over(stage: Stage) -> None:
    stage.begin("1")
    stage.play(2.5)
    assert stage.begin("2") == "1"
    assert stage.cameras.status("1") is None
    stage.play(0.5, link="2", jaw=0.06)
    assert stage.sources() == ["Camera Ada"]
    assert stage.begin("2") is None
    assert stage.begin("3", "Bo") is None


def test_a_face_that_is_lost_is_told_to_the_show(stage: Stage) -> None:
    stage.begin()
    stage.play(2.5)
    stage.play(0.5, jaw=0.06)
    stage.play(0.1, found=False)
    assert not stage.status().found
    assert [each.found for each in stage.session.sources.states({})] == [False]
    stage.play(0.1)
    assert stage.status().found


def test_what_cannot_be_done_is_rejected_with_a_reason(stage: Stage) -> None:
    before: tuple[tuple[wire.FromCamera, str], ...] = (
        (wire.Perform(99, "Ada"), "speaks version 99, the show 3"),
        (wire.Perform(wire.CAMERA_VERSION, " "), "give a name"),
        (wire.BeginGuide(), "nobody performs at this page yet"),
    )
    for message, reason in before:
        with pytest.raises(ValueError, match=reason):
            stage.cameras.obey("1", message)
    stage.begin()
    later: tuple[tuple[wire.FromCamera, str], ...] = (
        (wire.PlayCharacters(["nobody"]), "no character 'nobody'"),
        (wire.PlayHand(["nobody"], []), "no character 'nobody'"),
        (wire.RedoStep("aa"), "begin the guided minute"),
        (wire.DeletePerformer(), "no performer 'Ada'"),
        (wire.UndoPerformer(), "nothing to undo"),
    )
    for message, reason in later:
        with pytest.raises(ValueError, match=reason):
            stage.cameras.obey("1", message)
    for number in range(MOST_CAMERAS - 1):
        stage.begin(f"more {number}", f"Performer {number}")
    with pytest.raises(ValueError, match="close the page of one"):
        stage.begin("one too many", "Zoe")
    assert stage.begin("another page", "Ada") == "1"


def test_a_frame_that_cannot_be_read_is_told_and_counted(stage: Stage) -> None:
    stage.begin()
    stage.cameras.receive("1", b"OMLM")
    ((link, reason),) = stage.cameras.play(0.0)
    assert (link, stage.cameras.trackers.rejected) == ("1", 1)
    assert "4 bytes" in reason
    stage.cameras.receive("nobody", b"OMLM")
    assert stage.cameras.play(0.0) == []
