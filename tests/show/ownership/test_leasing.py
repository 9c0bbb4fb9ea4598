"""Leases in a session: who is rejected, who is told, what stays through a restart."""

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.scene.scene_snapshot import without_time
from omote.show.declaration import ClientMessage, Outgoing
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace, FadeExpression, FadeFace, Panic
from omote.show.objects.characters import AddCharacter, RemoveCharacter, RenameCharacter
from omote.show.objects.faders import SetChannel, SetHead
from omote.show.objects.leases import AppointManager, Lease, LeaseClaim, LeasePart, Leases, ReleaseLease, SetLeases
from omote.show.objects.link import Hello, Refused
from omote.show.objects.memories import CallMemory
from omote.show.objects.pictures import CallFraming, CallLight
from omote.show.ownership.leasing import AGAIN_SECONDS, LOOK_SECONDS, OFF, LeaseSnapshot
from omote.show.ownership.ownership_table import AWAY_SECONDS
from omote.show.session import ShowSession
from omote.show.session_snapshot import read_session_snapshot
from omote.show.wire import encode
from tests import synthetic

FACE = CallFace("one", "c1", synthetic.FACES[1], 1.0, "smooth")


def hello(name: str, seat: str = "") -> Hello:
    return Hello("console", PROTOCOL_VERSION, name, f"page of {name}", seat or name)


@pytest.fixture
def show(cast: Cast) -> ShowSession:
    """Ana is the stage manager, Ben and a lighting desk are there, leases are on; two characters."""
    session = ShowSession(cast)
    for who, name in (("a", "Ana"), ("b", "Ben")):
        session.receive(who, hello(name), 0.0)
    session.join("osc 10.0.0.5", "OSC 10.0.0.5")
    session.receive("a", AddCharacter("add", "two", "Two", "generic"), 0.0)
    assert session.receive("a", SetLeases("on", True), 0.0) == []
    return session


def told(session: ShowSession, who: str, now: float) -> Leases:
    """What a client is told of the leases."""
    return told_to_all(session, now)[who]


def told_to_all(session: ShowSession, now: float) -> dict[str, Leases]:
    """What clients are told of the leases."""
    return {each.who: each.message for each in session.hands_now(now) if isinstance(each.message, Leases)}


def held(session: ShowSession) -> dict[str, str]:
    """Who holds what, by name."""
    leasing = session.leasing
    return {key: leasing.seats[seat].name for key, seat in leasing.table.held.items()}


def refused(outgoing: list[Outgoing]) -> Refused:
    """The rejection that a client got."""
    found = [each.message for each in outgoing if isinstance(each.message, Refused)]
    assert len(found) == 1, outgoing
    return found[0]


def test_off_the_last_touch_wins_and_nobody_holds_anything(cast: Cast) -> None:
    session = ShowSession(cast)
    for who in "ab":
        session.receive(who, hello(who), 0.0)
        assert session.receive(who, SetChannel("one", "jawOpen", 0.5), 0.0) == []
    assert held(session) == {}
    assert told_to_all(session, 0.0) == {}, "a console takes that for granted"
    assert refused(session.receive("a", Lease("x", "one", "face"), 0.0)).reason == OFF


def test_the_first_touch_takes_a_part_and_anothers_is_rejected_with_the_holders_name(show: ShowSession) -> None:
    assert show.receive("a", FACE, 0.0) == []
    before = show.scene.snapshot()
    answers = show.receive("b", FadeFace("one", 0.5), 0.0)
    reason = refused(answers)
    assert reason.reason.startswith("Ana holds the face of one: take it over")
    assert reason.held == ["one/face"]
    assert show.scene.snapshot() == before
    claim = next(each for each in answers if isinstance(each.message, LeaseClaim))
    assert claim.who == "a", "the holder hears who wants it"
    assert isinstance(claim.message, LeaseClaim)
    assert (claim.message.parts, claim.message.by.name, claim.message.taken) == (["one/face"], "Ben", False)
    assert show.receive("b", FadeExpression("one", 0.5), 0.0) == [], "another part is free"
    assert held(show) == {"one/face": "Ana", "one/expression": "Ben"}


def test_a_holder_is_told_of_a_hand_that_goes_on_and_on_once_a_second(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    counts = [
        sum(isinstance(each.message, LeaseClaim) for each in show.receive("b", FadeFace("one", 0.5), now))
        for now in (0.0, 0.1, AGAIN_SECONDS, AGAIN_SECONDS + 0.1)
    ]
    assert counts == [1, 0, 1, 0]


def test_what_is_invalid_takes_nothing(show: ShowSession) -> None:
    assert refused(show.receive("b", SetChannel("one", "nobody", 0.5), 0.0)).held == []
    assert refused(show.receive("b", FadeFace("nobody", 0.5), 0.0)).held == []
    assert held(show) == {}


def test_who_takes_over_plays_and_the_other_is_told(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    (claim,) = show.receive("b", Lease("take", "one", "face", take_over=True), 0.0)
    assert (claim.who, getattr(claim.message, "taken", None)) == ("a", True)
    assert show.receive("b", FadeFace("one", 0.5), 0.0) == []
    assert refused(show.receive("a", FadeFace("one", 0.5), 0.0)).held == ["one/face"]


def test_a_message_for_all_is_obeyed_for_all_or_for_none(show: ShowSession) -> None:
    show.receive("a", FadeFace("two", 0.5), 0.0)
    still = show.scene.snapshot()
    answer = refused(show.receive("b", FadeFace("*", 0.7), 0.0))
    assert (answer.held, answer.reason[:27]) == (["two/face"], "Ana holds the face of two: ")
    assert (show.scene.snapshot(), held(show)) == (still, {"two/face": "Ana"})
    assert show.receive("a", FadeFace("*", 0.7), 0.0) == []
    assert held(show) == {"one/face": "Ana", "two/face": "Ana"}


def test_a_refusal_says_the_label_of_a_renamed_character(show: ShowSession) -> None:
    show.receive("a", RenameCharacter("r1", "two", "Rex"), 0.0)
    show.receive("a", FadeFace("two", 0.5), 0.0)
    reason = refused(show.receive("b", FadeFace("two", 0.7), 0.0)).reason
    assert reason.startswith("Ana holds the face of two (Rex): ")


def test_a_character_of_which_somebody_holds_a_part_is_not_removed(show: ShowSession) -> None:
    show.receive("b", SetHead("two", 0.1, 0.0, 0.0), 0.0)
    assert refused(show.receive("a", RemoveCharacter("r", "two"), 0.0)).held == ["two/head"]
    assert show.receive("b", RemoveCharacter("r", "two"), 0.0) == []
    for step in range(1, 200):
        show.tick(step / 60.0)
    assert (tuple(show.scene), held(show)) == (("one",), {})


def test_panic_passes_all_leases_and_changes_none(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    before = held(show)
    assert show.receive("b", Panic("*"), 0.0) == []
    assert held(show) == before


def test_a_lease_changes_no_number(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    show.tick(0.0)
    before = show.scene.snapshot()
    messages: list[ClientMessage] = [
        Lease("0", "one", "*"),
        Lease("1", "*", "light"),
        ReleaseLease("2", "one", "face"),
        ReleaseLease("3", "*", "*"),
        SetLeases("4", False),
    ]
    for message in messages:
        assert show.receive("a", message, 0.0) == []
    assert show.scene.snapshot() == before


def test_a_released_part_is_free_and_nobody_releases_for_others(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    assert refused(show.receive("b", ReleaseLease("r", "one", "face"), 0.0)).held == ["one/face"]
    assert show.receive("b", ReleaseLease("s", "*", "*"), 0.0) == []
    assert held(show) == {"one/face": "Ana"}
    assert show.receive("a", ReleaseLease("r", "one", "face"), 0.0) == []
    assert show.receive("b", FadeFace("one", 0.5), 0.0) == []
    assert held(show) == {"one/face": "Ben"}


def test_only_the_stage_manager_takes_over_everything_switches_off_and_passes_that_on(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    rejected: list[tuple[ClientMessage, str]] = [
        (Lease("x", "*", "*", take_over=True), r"only the stage manager \(Ana\) takes over everything"),
        (SetLeases("x", False), "Ana is the stage manager, who alone switches leases off"),
        (SetLeases("x", True), "Ana is the stage manager"),
        (AppointManager("x", 2), r"only the stage manager \(Ana\)"),
    ]
    for message, said in rejected:
        with pytest.raises(AssertionError, match=said):
            raise AssertionError(refused(show.receive("b", message, 0.0)).reason)
    told(show, "a", 0.0)
    number = {seat.name: seat.number for seat in show.leasing.seats.by_token.values()}
    assert "no seat 99" in refused(show.receive("a", AppointManager("y", 99), 0.0)).reason
    assert show.receive("a", AppointManager("z", number["Ben"]), 0.0) == []
    (claim,) = show.receive("b", Lease("w", "*", "*", take_over=True), 0.0)
    assert getattr(claim.message, "parts", None) == ["one/face"]
    assert {*held(show).values()} == {"Ben"}
    assert show.receive("b", SetLeases("v", False), 0.0) == []
    assert (held(show), told(show, "a", 0.0).on) == ({}, False)


def test_a_stage_manager_who_is_gone_lets_another_become_it(show: ShowSession) -> None:
    show.tick(0.0)
    show.leave("a", lost=0.0)
    show.tick(0.1)
    show.tick(0.1 + AWAY_SECONDS)
    assert show.receive("b", SetLeases("mine", True), 6.0) == []
    assert [(seat.name, seat.manager) for seat in told(show, "b", 6.0).seats] == [("Ben", True)]


@pytest.mark.parametrize("late", [False, True])
def test_a_reload_keeps_the_seat_and_one_who_stays_away_loses_what_it_held(show: ShowSession, late: bool) -> None:
    show.receive("b", FACE, 0.0)
    seat = next(seat for seat in told(show, "b", 0.0).seats if seat.name == "Ben")
    show.leave("b")
    show.tick(1.0)
    back = 1.0 + AWAY_SECONDS if late else AWAY_SECONDS
    show.tick(back)
    assert held(show) == ({} if late else {"one/face": "Ben"})
    show.receive("c", Hello("console", PROTOCOL_VERSION, "Ben", "another page", "Ben"), back)
    show.tick(9.0)
    now = told(show, "c", 9.0)
    assert (now.you, seat.colour) == (seat.number, next(each.colour for each in now.seats if each.name == "Ben"))
    assert now.held == ({} if late else {"one/face": seat})


def test_a_second_link_of_a_seat_holds_what_the_first_does(show: ShowSession) -> None:
    show.receive("b", FACE, 0.0)
    show.receive("c", Hello("console", PROTOCOL_VERSION, "Tablet", "t", "Ben"), 0.0)
    assert show.receive("c", FadeFace("one", 0.5), 0.0) == []
    show.leave("b")
    for now in (1.0, 10.0):
        show.tick(now)
    assert [*held(show)] == ["one/face"]


def test_a_source_holds_under_its_own_name_and_a_device_for_the_seat_of_its_page(show: ShowSession) -> None:
    assert show.receive("osc 10.0.0.5", FACE, 0.0) == []
    assert refused(show.receive("a", FadeFace("one", 0.1), 0.0)).reason.startswith("OSC 10.0.0.5 holds the face")
    show.join("device knobs", "knobs", show.crew["b"].seat)
    show.receive("device knobs", SetChannel("one", "jawOpen", 0.5), 0.0)
    assert held(show) == {"one/face": "OSC 10.0.0.5", "one/channels": "Ben"}
    assert show.receive("b", SetChannel("one", "jawOpen", 0.6), 0.0) == []


def test_consoles_are_told_what_changes_and_the_same_once_a_second(show: ShowSession) -> None:
    first = told_to_all(show, 0.0)
    assert [first["a"].you, first["b"].you] == [1, 2]
    assert told_to_all(show, LOOK_SECONDS) == {}
    show.receive("b", FACE, LOOK_SECONDS)
    now = told(show, "a", LOOK_SECONDS)
    assert {key: seat.name for key, seat in now.held.items()} == {"one/face": "Ben"}
    assert [seat.manager for seat in now.seats] == [True, False]
    assert {*told_to_all(show, LOOK_SECONDS + AGAIN_SECONDS)} == {"a", "b"}


def test_a_seat_has_the_name_of_its_console_as_it_is_now(show: ShowSession) -> None:
    show.receive("b", FACE, 0.0)
    show.receive("b", Hello("console", PROTOCOL_VERSION, "Eva", "page of Ben", "Ben"), 0.0)
    assert {key: seat.name for key, seat in told(show, "a", 1.0).held.items()} == {"one/face": "Eva"}


def test_leases_and_the_switch_go_on_after_a_restart(cast: Cast, show: ShowSession) -> None:
    show.receive("b", FACE, 0.0)
    before = told(show, "b", 0.0)
    snapshot, _ = read_session_snapshot(msgspec.msgpack.decode(encode(show.snapshot())))
    again = ShowSession.restored(cast, snapshot, epoch=2)
    again.tick(100.0)
    for who, name in (("7", "Ana"), ("8", "Ben")):
        again.receive(who, hello(name), 101.0)
    again.tick(100.0 + AWAY_SECONDS)
    after = told(again, "8", 106.0)
    assert (after.on, after.held, after.you, after.seats) == (before.on, before.held, before.you, before.seats)


def test_a_show_that_knew_no_leases_opens_with_them_off(cast: Cast, show: ShowSession) -> None:
    saved = msgspec.to_builtins(show.snapshot())
    del saved["leases"]
    snapshot, _ = read_session_snapshot(saved)
    assert snapshot.leases == LeaseSnapshot()
    assert without_time(snapshot.scene) == without_time(show.scene.snapshot())


def test_an_id_executes_once_and_a_stage_asks_for_nothing(show: ShowSession) -> None:
    release = ReleaseLease("once", "one", "face")
    show.receive("a", release, 0.0)
    show.receive("a", FACE, 0.0)
    assert show.receive("a", release, 0.0) == []
    assert held(show) == {"one/face": "Ana"}
    show.receive("s", Hello("stage", PROTOCOL_VERSION), 0.0)
    assert "only a console plays" in refused(show.receive("s", SetLeases("q", True), 0.0)).reason


@pytest.mark.parametrize(
    ("character", "part", "said"),
    [("nobody", "face", "there is no character 'nobody'"), ("one", "light", "the light belongs to the scene")],
)
def test_what_cannot_be_leased_is_rejected_with_what_can(
    show: ShowSession, character: str, part: LeasePart, said: str
) -> None:
    for message in (Lease("x", character, part), ReleaseLease("x", character, part)):
        assert said in refused(show.receive("a", message, 0.0)).reason


def wishes(said: Leases) -> list[tuple[str, str, int]]:
    """What a console is told that somebody wants: part, name, seconds."""
    names = {seat.number: seat.name for seat in said.seats}
    return [(each.part, names[each.by], each.seconds) for each in said.wishes]


def test_a_wish_stands_for_all_consoles_with_its_seconds_until_the_part_is_released(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    show.receive("b", FadeFace("one", 0.5), 10.0)
    for now in (10.0, 75.0):
        show.tick(now)
        found = told_to_all(show, now)
        assert [wishes(found[who]) for who in "ab"] == [[("one/face", "Ben", int(now) - 10)]] * 2
    show.receive("a", ReleaseLease("r", "one", "face"), 80.0)
    show.tick(80.0)
    assert wishes(told(show, "b", 80.0)) == []


def test_who_wants_a_part_takes_the_wish_back_and_its_holder_answers_that_it_is_kept(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    show.receive("b", FadeFace("one", 0.5), 0.0)
    assert show.receive("b", ReleaseLease("w", "one", "face"), 1.0) == []
    assert wishes(told(show, "a", 1.0)) == []
    assert refused(show.receive("b", ReleaseLease("w2", "one", "face"), 1.0)).held == ["one/face"]
    show.receive("b", FadeFace("one", 0.5), 2.0)
    (answer,) = show.receive("a", Lease("k", "one", "face"), 3.0)
    assert isinstance(answer.message, LeaseClaim)
    assert (answer.who, answer.message.parts, answer.message.by.name) == ("b", ["one/face"], "Ana")
    assert (answer.message.kept, answer.message.taken) == (True, False)
    assert wishes(told(show, "b", 3.0)) == []
    assert held(show) == {"one/face": "Ana"}


def test_a_lighting_desk_that_wants_a_part_is_named(show: ShowSession) -> None:
    show.receive("a", FACE, 0.0)
    show.receive("osc 10.0.0.5", FadeFace("one", 0.5), 0.0)
    assert wishes(told(show, "a", 0.0)) == [("one/face", "OSC 10.0.0.5", 0)]


@pytest.mark.parametrize(
    ("message", "unknown"),
    [
        (CallFace("one", "c1", "nobody", 1.0, "smooth"), "face 'nobody'"),
        (CallExpression("one", "c1", "nothing", 1.0, "smooth"), "expression 'nothing'"),
        (CallMemory("c1", "nope"), "memory 'nope'"),
        (SetChannel("one", "nothing", 0.5), "channel 'nothing'"),
        (CallLight("c1", "dark"), "light 'dark'"),
        (CallFraming("c1", ["nobody"]), "character 'nobody'"),
    ],
)
def test_what_there_is_not_is_told_before_who_holds_it_and_nobody_is_asked_for_it(
    show: ShowSession, message: ClientMessage, unknown: str
) -> None:
    show.receive("a", Lease("all", "*", "*", take_over=True), 0.0)
    outgoing = show.receive("b", message, 0.0)
    assert f"there is no {unknown}" in refused(outgoing).reason
    assert refused(outgoing).held == []
    assert len(outgoing) == 1
