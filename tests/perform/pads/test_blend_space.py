"""Soft bands: exact at looks, a share of one everywhere, smooth where looks move; and what no pad can be."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from numpy.typing import NDArray

from omote.perform.pads.blend_space import LEAST_APART, MOST_LOOKS, Pad, PadLook, fitted

Places = NDArray[np.float64]
WIDTH = 2.0
"""From one end of a pad to the other: places of looks are given in widths in the design, from -1 to 1 here."""
LAYOUTS = 1000


def layouts(dimensions: int, seed: int, apart: float = 0.12) -> Iterator[Places]:
    """Random places of 2 to 12 looks, as far apart as in the design, widths."""
    rng = np.random.default_rng([seed, dimensions])
    while True:
        wanted = int(rng.integers(2, MOST_LOOKS + 1))
        places: list[list[float]] = []
        for place in rng.uniform(-1.0, 1.0, (5 * wanted, dimensions)).tolist():
            if len(places) < wanted and all(math.dist(place, other) >= WIDTH * apart for other in places):
                places.append(place)
        if len(places) >= 2:
            yield np.array(places)


def pad_of(places: Places) -> Pad:
    """A pad with a look of its own name at each place."""
    looks = [PadLook(f"l{n}", {f"n{n}": 1.0}, tuple(map(float, place))) for n, place in enumerate(places)]
    return Pad("pad", "expression", places.shape[1], tuple(looks))


def soft_bands(places: Places, at: Places) -> Places:
    """The formula as the design has it, by NumPy."""
    to = places[None] - places[:, None]
    square = (to**2).sum(-1)
    np.fill_diagonal(square, 1.0)
    t = ((at - places)[:, None] * to).sum(-1) / square
    u = np.clip(t, 0.0, 1.0 - 1e-15)
    against = np.where(t >= 1.0, np.inf, (u / (1.0 - u)) ** 1.5)
    weights = 1.0 / (1.0 + against.sum(1))
    return np.asarray(weights / weights.sum())


@pytest.mark.parametrize("dimensions", [1, 2, 3])
def test_weights_are_exact_at_looks_and_a_share_of_one_everywhere(dimensions: int) -> None:
    rng = np.random.default_rng(dimensions)
    for _, places in zip(range(LAYOUTS), layouts(dimensions, 1), strict=False):
        pad = pad_of(places)
        for n, place in enumerate(places):
            assert pad.weights_at(tuple(map(float, place))) == [float(n == other) for other in range(len(places))]
        at = rng.uniform(-1.0, 1.0, dimensions)
        weights = pad.weights_at(tuple(map(float, at)))
        assert min(weights) >= 0.0
        assert abs(math.fsum(weights) - 1.0) <= 1e-12
        np.testing.assert_allclose(weights, soft_bands(places, at), atol=1e-12)


@pytest.mark.parametrize("dimensions", [1, 2, 3])
def test_a_look_that_is_dragged_a_little_moves_weights_a_little(dimensions: int) -> None:
    """By .0005 widths no weight by .02."""
    rng = np.random.default_rng(dimensions)
    worst = 0.0
    for _, places in zip(range(LAYOUTS), layouts(dimensions, 2), strict=False):
        at = tuple(map(float, rng.uniform(-1.0, 1.0, dimensions)))
        dragged = places.copy()
        which = int(rng.integers(len(places)))
        way = rng.normal(size=dimensions)
        dragged[which] = np.clip(places[which] + 0.0005 * WIDTH * way / np.linalg.norm(way), -1.0, 1.0)
        before, after = pad_of(places).weights_at(at), pad_of(dragged).weights_at(at)
        worst = max(worst, float(np.abs(np.subtract(after, before)).max()))
    assert 0.0 < worst < 0.02


@pytest.mark.parametrize("dimensions", [1, 2, 3])
def test_what_bends_at_a_look_vanishes_with_the_step(dimensions: int) -> None:
    """Continuous slopes, at looks too: the change of slope falls as the root of the step."""
    rng = np.random.default_rng(dimensions)
    for _, places in zip(range(60), layouts(dimensions, 3), strict=False):
        pad = pad_of(places)
        look = places[int(rng.integers(len(places)))]
        way = rng.normal(size=dimensions)
        way /= np.linalg.norm(way)
        bends = []
        for step in (1e-3, 1e-5):
            line = [np.array(pad.weights_at(_inside(look + side * step * way))) for side in (-1.0, 0.0, 1.0)]
            bends.append(np.abs(line[2] - 2.0 * line[1] + line[0]).max() / step)
        assert bends[1] <= 0.2 * bends[0] + 1e-9 or _is_outside(look, way)


def _inside(place: Places) -> tuple[float, ...]:
    return tuple(map(float, np.clip(place, -1.0, 1.0)))


def _is_outside(look: Places, way: Places) -> bool:
    return bool(np.any(np.abs(look) + 1e-3 * np.abs(way) > 1.0))


def test_far_looks_show_nothing_behind_a_nearer_one() -> None:
    pad = pad_of(np.array([[-1.0], [0.0], [1.0]]))
    for x in np.linspace(-1.0, 0.0, 21).tolist():
        assert pad.weights_at((x,))[2] == 0.0


def test_looks_on_one_line_of_a_square_stand_as_on_a_line() -> None:
    line = pad_of(np.array([[-0.7], [0.1], [0.8]]))
    square = pad_of(np.array([[-0.7, 0.3], [0.1, 0.3], [0.8, 0.3]]))
    for x in np.linspace(-1.0, 1.0, 41).tolist():
        assert square.weights_at((x, -0.9)) == pytest.approx(line.weights_at((x,)), abs=1e-12)


def test_a_mix_is_that_of_its_looks_and_what_is_lost_counts_as_another() -> None:
    looks = (PadLook("A", {"a": 0.5, "b": 0.5}, (-1.0,)), PadLook("B", {"b": 1.0}, (1.0,)))
    pad = Pad("pad", "mouth", 1, looks)
    assert pad.mix_at((0.0,)) == {"a": 0.25, "b": 0.75}
    assert pad.mix_at((0.0,), {"b", "neutral"}, instead="neutral") == {"neutral": 0.25, "b": 0.75}
    assert (pad.lost({"b"}), pad.lost({"a", "b"})) == (["a"], [])


def test_a_place_keeps_what_is_not_given() -> None:
    pad = pad_of(np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]))
    assert pad.moved((), 0.5, None, None) == (0.5, 0.0, 0.0)
    assert pad.moved((0.1, 0.2, 0.3), None, -1, None) == (0.1, -1.0, 0.3)
    assert (fitted((0.1,), 3), fitted((0.1, 0.2, 0.3), 2)) == ((0.1, 0.0, 0.0), (0.1, 0.2))


def test_a_pad_is_the_same_after_it_was_written_and_read() -> None:
    pad = pad_of(next(layouts(3, 4)))
    pad.weights_at((0.1, 0.2, 0.3))  # which remembers its places
    for code in (msgspec.json, msgspec.msgpack):
        assert code.decode(code.encode(pad), type=Pad) == pad


A = PadLook("A", {"a": 1.0}, (0.0, 0.0))
B = PadLook("B", {"b": 1.0}, (1.0, 0.0))
PAD = Pad("pad", "mouth", 2, (A, B))
WRONG: dict[str, Callable[[], object]] = {
    "the name of a pad is ''": lambda: replace(PAD, name=""),
    "the name of a pad is 5": lambda: replace(PAD, name=5),  # type: ignore[arg-type]
    "cannot be named 'a/b', for '/'": lambda: replace(PAD, name="a/b"),
    "cannot be named 'a b', for ' '": lambda: replace(PAD, name="a b"),
    "part that a pad plays": lambda: replace(PAD, part="nose"),  # type: ignore[arg-type]
    "has 4 dimensions": lambda: replace(PAD, dimensions=4),
    "has 1 looks; a pad has 2 to 12": lambda: replace(PAD, looks=(A,)),
    "has 13 looks": lambda: replace(PAD, looks=(A,) * 13),
    "has 2 numbers; the pad pad has 1": lambda: replace(PAD, dimensions=1),
    "are called 'a'": lambda: replace(PAD, looks=(A, replace(B, label="a"))),
    f"apart; move them {LEAST_APART}": lambda: replace(PAD, looks=(A, replace(B, place=(0.0, 0.05)))),
    "the label of a look is ' '": lambda: replace(A, label=" "),
    "give the weights of 1 to 24 names": lambda: replace(A, mix={}),
    "sum to 0.5; they must sum to 1": lambda: replace(A, mix={"a": 0.5}),
    "a in A is 1.5": lambda: replace(A, mix={"a": 1.5, "b": -0.5}),
    "the place of A is 1.5": lambda: replace(A, place=(1.5, 0.0)),
    "1 numbers came for the pad pad": lambda: PAD.weights_at((0.0,)),
    "y of a pad is -2": lambda: PAD.weights_at((0.0, -2.0)),
    "has 2 dimensions and no z": lambda: PAD.moved((), 0.0, 0.0, 0.0),
}


@pytest.mark.parametrize("message", WRONG)
def test_what_no_pad_can_be_is_refused_in_words(message: str) -> None:
    with pytest.raises(ValueError, match=message.replace("(", "\\(")):
        WRONG[message]()


def test_what_is_no_look_and_no_number_is_refused() -> None:
    with pytest.raises(TypeError, match="a look of the pad pad is a str"):
        replace(PAD, looks=(A, "b"))  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="x of a pad must be a number, not '1'"):
        PAD.weights_at(("1", 0.0))  # type: ignore[arg-type]
