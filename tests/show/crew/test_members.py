"""Who is connected; the session's tests have the messages."""

import pytest

from omote.show.access.people_list import Visitor
from omote.show.crew.members import LOST_SECONDS, Members
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.link import Hello
from omote.show.objects.stages import Crew, Drawing
from omote.show.validation import Refusal

HELLO = Hello("console", PROTOCOL_VERSION, "Mia", "page")


def test_who_said_no_hello_is_nobody() -> None:
    members = Members()
    with pytest.raises(Refusal, match="before hello"):
        members["a"]
    with pytest.raises(Refusal, match="before hello"):
        members.report("a", Drawing(60.0, "high"), 0.0)
    assert members.present == {}


def test_a_name_that_is_claimed_is_taken_from_who_was_given_it() -> None:
    members = Members()
    assert members.admit("a", Hello("console", PROTOCOL_VERSION)) == ["a"]
    given = members["a"].name
    claims = Hello("console", PROTOCOL_VERSION, given)
    assert members.admit("b", claims) == ["b", "a"]
    assert members.consoles()["b"] == given != members.consoles()["a"]


def test_the_name_of_a_token_is_its_own() -> None:
    members = Members()
    members.people = lambda: ["Ann", "Ben"]
    members.identify("guest", Visitor("operate"))
    assert members.admit("guest", Hello("console", PROTOCOL_VERSION, "ann")) == ["guest"]
    assert members["guest"].name == "console 1", "the name is kept for who is not here yet"
    members.people = lambda: []
    members.admit("guest", Hello("console", PROTOCOL_VERSION, "Ann"))
    assert members["guest"].name == "Ann"
    members.people = lambda: ["Ann", "Ben"]
    members.identify("desk", Visitor("operate", "Ann", "ann's id"))
    assert members.admit("desk", Hello("console", PROTOCOL_VERSION, "Somebody", "page")) == ["desk", "guest"]
    assert members.consoles() == {"desk": "Ann", "guest": "console 1"}
    members.identify("tablet", Visitor("operate", "Ann", "ann's id"))
    members.admit("tablet", Hello("console", PROTOCOL_VERSION, "Ben"))
    members.admit("guest", Hello("console", PROTOCOL_VERSION, "Ann 2"))
    assert members.consoles() == {"desk": "Ann", "tablet": "Ann 2", "guest": "console 1"}


def test_roles_are_told_apart() -> None:
    members = Members()
    members.admit("a", HELLO)
    members.admit("s", Hello("stage", PROTOCOL_VERSION))
    members.join("o", "OSC")
    assert (members.consoles(), members.sources()) == ({"a": "Mia"}, {"o": "OSC"})
    assert members.links_of_page("page") == ["a"]
    assert members.links_of_page("") == []
    assert members.now(0.0) == Crew([None], 1)


def test_only_a_stage_whose_link_broke_is_missed() -> None:
    members = Members()
    members.admit("a", HELLO)
    members.admit("s", Hello("stage", PROTOCOL_VERSION))
    for who in ("a", "s"):
        members.leave(who, lost=5.0)
    assert members.now(5.0) == Crew([], 0, 1)
    assert members.now(5.1 + LOST_SECONDS) == Crew([], 0, 0)
