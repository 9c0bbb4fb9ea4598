"""Roles are a ladder."""

from itertools import product

from omote.show.access.access_role import ACCESS_ROLES, HIGHEST, explain_missing_role, role_allows


def test_each_role_may_what_those_before_it_may() -> None:
    for (i, held), (j, needed) in product(enumerate(ACCESS_ROLES), repeat=2):
        assert role_allows(held, needed) == (i >= j)
    assert ACCESS_ROLES[-1] == HIGHEST


def test_who_may_not_is_told_both_roles_and_what_to_do() -> None:
    sentence = explain_missing_role("view", "edit")
    assert '"view"' in sentence
    assert '"edit"' in sentence
    assert "ask" in sentence
