"""New identities by seed, from the modes that were baked: each one is checked before it is given out."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from omote.builtin import load_cast, load_identity_modes
from omote.model.cast import Cast, Look
from omote.model.fitting.identity_modes import IdentityModes, refuse_other_topology
from omote.model.fitting.random_identities import TRIED, draw_identity, find_faults
from omote.model.recipes.compose_face import mix_looks
from omote.model.space.face import Face
from omote.perform.snapshot import refuse_no_cast

MOST_FACES = 1000
TRIES = 20
"""How often somebody is drawn anew before it is said that this does not end."""
COLOURED = ("generic", "kaori", "round", "child", "old", "man", "gaunt", "heavy", "auntie", "count")
"""Of the cast, whose colours and hair new faces mix: those of people with hair."""


def add_random_faces(cast: Cast, count: int, *, seed: int = 0) -> Cast:
    """The cast with new faces of nobody, the same ones for the same seed.

    Shapes are independent normal weights, 2.5 standard deviations at most, of 110 modes of 900 heads; colours and hair
    are mixed from two people of the built-in cast, whatever the shape. Every face is looked through: nothing folds at
    rest and in six expressions, both eyes shut, teeth lie behind the skin; who fails is drawn anew.

    Parameters
    ----------
    cast : Cast
        On the built-in head.
    count : int
        How many, 1 to 1000, about a second each.
    seed : int
        0 or more; the first ten of fifty are those of ten.

    Returns
    -------
    Cast
        With "random_3_001" and so on after the faces of before, for seed 3.

    Raises
    ------
    ValueError
        For a count or a seed that is none, a cast on another head, and where the cast has such faces already.
    TypeError
        For what is no whole number.

    Examples
    --------
    >>> more = omote.add_random_faces(cast, 1, seed=3)
    >>> [*more.faces][-1], len(more.faces) - len(cast.faces)
    ('random_3_001', 1)

    References
    ----------
    Blanz and Vetter (1999); docs/method.md.
    """
    refuse_no_cast(cast)
    refuse_strange_count(count, seed)
    refuse_other_topology(cast.space, load_identity_modes())
    drawn = list(draw_random_faces(count, seed))
    if there := [face.name for face, _ in drawn if face.name in cast.faces]:
        raise ValueError(f"the cast has a face {there[0]!r} already; give another seed than {seed}")
    return cast.with_faces(*(face for face, _ in drawn), looks={face.name: look for face, look in drawn})


def refuse_strange_count(count: int, seed: int, /) -> None:
    """Raises for a count or a seed that is no whole number (TypeError) or out of range (ValueError)."""
    for what, number in (("count", count), ("seed", seed)):
        if not isinstance(number, int | np.integer) or isinstance(number, bool):
            raise TypeError(f"the {what} of random faces is {number!r}; give a whole number, such as 3")
    if not 1 <= count <= MOST_FACES:
        raise ValueError(f"{count} random faces cannot be drawn; give 1 to {MOST_FACES}")
    if seed < 0:
        raise ValueError(f"the seed is {seed}; give 0 or more")


def draw_random_faces(count: int, seed: int, /) -> Iterator[tuple[Face, Look]]:
    """New faces of the built-in head with their looks, one after another.

    count, seed: as of `add_random_faces`, whole and in range.
    """
    cast = load_cast()
    modes = load_identity_modes()
    for number in range(1, count + 1):
        yield _draw_face(cast, modes, f"random_{seed}_{number:03d}", seed, number), _draw_look(cast, seed, number)


def _draw_face(cast: Cast, modes: IdentityModes, name: str, seed: int, number: int) -> Face:
    """The first face of those drawn under a number that has no faults."""
    tried = {expression: cast.expressions[expression] for expression in TRIED}
    for attempt in range(TRIES):
        face = draw_identity(cast.space, modes, name, np.random.default_rng([seed, number, attempt]))
        if not find_faults(cast.space, modes.skin, face, tried):
            return face
    raise RuntimeError(f"of {TRIES} heads drawn as {name} each has faults; give another seed")


def _draw_look(cast: Cast, seed: int, number: int) -> Look:
    """Colours and hair between two people of the cast."""
    draw = np.random.default_rng([seed, number, TRIES])  # after those of the attempts at its shape
    one, other = draw.choice(COLOURED, 2, replace=False)
    share = float(draw.uniform())
    return mix_looks([(cast.looks[str(one)], share), (cast.looks[str(other)], 1.0 - share)])
