"""The seats of a show: operators, and sources that hold something, each with a number, a name and a colour."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

COLOURS = ("#70ccee", "#cd509f", "#8f893b", "#2885ef", "#f7a597", "#bcfa99")
"""Colours of seats: apart from each other, for people with any form of colour blindness too, and from those by which
pages say what is on air, coming and wanted."""
MOST_SEATS = 64
"""Seats that are remembered; the one that was seen first makes room."""


@dataclass(frozen=True)
class Seat:
    """A seat: its number, what it was called last, and its colour."""

    number: int
    name: str
    colour: str


class Seats:
    """All seats that were seen, by token; one that comes back is what it was."""

    def __init__(self, known: Mapping[str, Seat] | None = None) -> None:
        self.known: dict[str, Seat] = dict(known or {})

    def __getitem__(self, token: str) -> Seat:
        return self.known[token]

    def __contains__(self, token: str) -> bool:
        return token in self.known

    def meet(self, token: str, name: str, needed: Collection[str]) -> None:
        """Notes the name of a seat, a new one too; needed: those that must not be forgotten."""
        if token in self.known:
            if self.known[token].name != name:
                self.known[token] = replace(self.known[token], name=name)
            return
        spare = next((each for each in self.known if each not in needed), None)
        if len(self.known) >= MOST_SEATS and spare is not None:
            del self.known[spare]
        number = 1 + max((seat.number for seat in self.known.values()), default=0)
        self.known[token] = Seat(number, name, self._free_colour(needed))

    def token_of(self, number: int) -> str | None:
        """The token of the seat with a number; None where there is none."""
        return next((token for token, seat in self.known.items() if seat.number == number), None)

    def _free_colour(self, needed: Collection[str]) -> str:
        """The colour that fewest seats have: of those that are here, then of all."""
        here = [seat.colour for token, seat in self.known.items() if token in needed]
        seen = [seat.colour for seat in self.known.values()]
        return min(COLOURS, key=lambda colour: (here.count(colour), seen.count(colour), COLOURS.index(colour)))
