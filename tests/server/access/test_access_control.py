"""Who sends a request, and a list that changes under the running show."""

from pathlib import Path

import pytest
from aiohttp.test_utils import make_mocked_request

from omote.server.access.access_control import AccessControl, DeniedError, read_cookies, visitor_of
from omote.server.access.people_file import change_people, new_person, open_people
from omote.show.access.people_list import add_person, remove_person, token_of
from omote.show.validation import Refusal


@pytest.fixture
def control(tmp_path: Path) -> AccessControl:
    return AccessControl(tmp_path / "a.people", open_people(tmp_path / "a.people"))


def test_a_shared_token_gives_no_name_and_an_own_one_does() -> None:
    assert visitor_of(new_person("operate", "operate", 0.0)).name == ""
    assert visitor_of(new_person("Ada", "operate", 0.0)).name == "Ada"


@pytest.mark.parametrize(
    ("lines", "values"),
    [
        (["a=1"], ["1"]),
        (["a=1; b=2;a=3"], ["1", "3"]),
        (["a=1", "a=2"], ["1", "2"]),
        (['a="1"'], ["1"]),
        (["b=a=1; aa=2; A=3; a"], [""]),
        ([], []),
    ],
)
def test_every_value_of_a_cookie_is_seen(lines: list[str], values: list[str]) -> None:

    assert read_cookies(lines, "a") == values


@pytest.mark.asyncio
async def test_a_change_holds_at_once_and_is_in_the_file(control: AccessControl) -> None:
    ada = new_person("Ada", "operate", 0.0)
    await control.change(lambda people: add_person(people, ada))
    assert control.holds(visitor_of(ada))
    assert open_people(control.path) == control.people
    await control.change(lambda people: remove_person(people, ada.id)[0])
    assert not control.holds(visitor_of(ada))
    with pytest.raises(Refusal):
        await control.change(lambda people: remove_person(people, "admin")[0])
    assert open_people(control.path) == control.people


def test_what_another_program_changes_is_taken_up(control: AccessControl) -> None:
    token = token_of(control.people, control.people.people[0])
    request = make_mocked_request("GET", "/", {"Authorization": f"Bearer {token}"})
    assert control.find_visitor(request)[0].role == "view"
    change_people(control.path, lambda people: remove_person(people, "view")[0])
    control.reload()
    with pytest.raises(DeniedError, match="your token was revoked"):
        control.find_visitor(request)


@pytest.mark.parametrize("content", [None, b"", b"{}", b"\xff"])
def test_a_list_that_is_gone_or_broken_stays_as_it_was(tmp_path: Path, content: bytes | None) -> None:
    said: list[str] = []
    people = open_people(tmp_path / "a.people")
    control = AccessControl(tmp_path / "a.people", people, report=said.append)
    (tmp_path / "a.people").unlink()
    if content is not None:
        (tmp_path / "b").write_bytes(content)
        (tmp_path / "b").replace(tmp_path / "a.people")
    for _ in range(3):
        control.reload()
    assert control.people == people
    assert len(said) == (content is not None)


def test_a_right_token_is_let_in_however_many_wrong_ones_came_from_its_address(control: AccessControl) -> None:
    def ask(token: str) -> str:
        return control.find_visitor(make_mocked_request("GET", "/", {"Authorization": f"Bearer {token}"}))[0].role

    waits = []
    for number in range(20):
        with pytest.raises(DeniedError) as denied:
            ask(f"wrong {number}")
        waits.append(denied.value.wait)
    assert (waits[0], denied.value.status) == (0.0, 429)
    assert waits[-1] > waits[-9] > 0.0
    assert ask(token_of(control.people, control.people.people[0])) == "view"
