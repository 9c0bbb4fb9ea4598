"""Which role each address needs; that the router has no other is stated in tests/server/access/test_access_guard.py."""

from omote.show.access.access_role import HIGHEST
from omote.show.access.route_roles import ROUTES, UNKNOWN_ROUTE, role_for_route


def test_an_address_needs_what_its_row_says_by_head_too() -> None:
    for (method, route), role in ROUTES.items():
        assert role_for_route(method, route) == role
        if method == "GET":
            assert role_for_route("HEAD", route) == role


def test_what_has_no_row_needs_the_highest_role_and_what_is_not_there_still_a_token() -> None:
    assert role_for_route("GET", "/new") == role_for_route("PUT", "/manifest") == HIGHEST
    assert role_for_route("GET", None) == UNKNOWN_ROUTE


def test_nothing_is_changed_by_those_who_only_look() -> None:
    assert [key for key, role in ROUTES.items() if key[0] != "GET" and role in ("view", "operate")] == [
        ("POST", "/markers"),  # a director notes what has to be better, and moves nothing
        ("POST", "/markers/{id}"),  # of own notes: others' ask for `operate`
        ("DELETE", "/markers/{id}"),
        ("POST", "/sounds"),  # is kept in no file: what is played, as a call is
        ("POST", "/voices"),  # a sound of a text, kept in no file either
    ]
