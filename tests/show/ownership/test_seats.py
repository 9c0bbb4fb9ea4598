"""Seats keep their numbers, names and colours."""

import itertools

import numpy as np
from numpy.typing import NDArray

from omote.show.ownership.seats import COLOURS, MOST_SEATS, Seats

# How people with each form of colour blindness see linear RGB: Machado, Oliveira and Fernandes 2009, severity 1.
SIGHTS = {
    "usual": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritanopia": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}
# Ottosson 2020: from linear RGB to the cube roots of cone responses, and from these to Oklab.
CONES = [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566]]
CONES += [[0.0883024619, 0.2817188376, 0.6299787005]]
OKLAB = [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099]]
OKLAB += [[0.0259040371, 0.7827717662, -0.8086757660]]


def linear(colour: str) -> NDArray[np.float64]:
    """The linear RGB of `#rrggbb`."""
    channels = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255.0
    return np.where(channels <= 0.04045, channels / 12.92, ((channels + 0.055) / 1.055) ** 2.4)


def seen(colour: str, sight: str) -> NDArray[np.float64]:
    """A colour in Oklab, as somebody sees it."""
    light: NDArray[np.float64] = np.clip(np.array(SIGHTS[sight]) @ linear(colour), 0.0, 1.0)
    found: NDArray[np.float64] = np.array(OKLAB) @ np.cbrt(np.array(CONES) @ light)
    return found


def test_colours_are_told_apart_with_any_sight_and_black_is_read_on_them() -> None:
    for sight in SIGHTS:
        for one, other in itertools.combinations(COLOURS, 2):
            apart = float(np.linalg.norm(seen(one, sight) - seen(other, sight)))
            assert apart > 0.12, (sight, one, other)
    for colour in COLOURS:
        assert float(linear(colour) @ [0.2126, 0.7152, 0.0722]) + 0.05 > 5.0 * 0.05, colour


def test_a_seat_that_comes_back_is_what_it_was_and_may_have_another_name() -> None:
    seats = Seats()
    for token in "abc":
        seats.meet(token, token.upper(), "abc")
    before = seats["b"]
    seats.meet("b", "Ben", "abc")
    assert (seats["b"].number, seats["b"].colour, seats["b"].name) == (before.number, before.colour, "Ben")
    assert seats.token_of(before.number) == "b"
    assert seats.token_of(99) is None


def test_seats_that_are_here_have_colours_of_their_own_while_there_are_enough() -> None:
    seats = Seats()
    for count in range(len(COLOURS)):
        here = [f"{count} {each}" for each in range(len(COLOURS))]
        for token in here:
            seats.meet(token, token, here)
        assert {seats[token].colour for token in here} == {*COLOURS}, "others that are away may have them too"


def test_the_memory_of_seats_is_bounded_and_those_that_are_needed_stay() -> None:
    seats = Seats()
    seats.meet("held", "Ana", ["held"])
    for number in range(2 * MOST_SEATS):
        seats.meet(str(number), "x", ["held", str(number)])
    assert len(seats.by_token) == MOST_SEATS
    assert "held" in seats
    numbers = [seat.number for seat in seats.by_token.values()]
    assert len({*numbers}) == len(numbers)
