"""The roles of the people of a show: each may do all that those before it may."""

from __future__ import annotations

from typing import Literal, get_args

AccessRole = Literal["view", "operate", "edit", "admin"]
ACCESS_ROLES: tuple[AccessRole, ...] = get_args(AccessRole)
HIGHEST: AccessRole = "admin"
_RANKS = {role: rank for rank, role in enumerate(ACCESS_ROLES)}


def role_allows(held: AccessRole, needed: AccessRole) -> bool:
    """Whether somebody who has the role `held` may do what needs the role `needed`."""
    return _RANKS[held] >= _RANKS[needed]


def explain_missing_role(held: AccessRole, needed: AccessRole) -> str:
    """Why somebody with the role `held` may not do what needs the role `needed`, as a whole sentence with what to
    do."""
    return f'this needs the role "{needed}", and you are here with "{held}": ask whoever runs the show for a token.'
