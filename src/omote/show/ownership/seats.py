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

    def __init__(self, by_token: Mapping[str, Seat] | None = None) -> None:
        self.by_token: dict[str, Seat] = dict(by_token or {})

    def __getitem__(self, token: str) -> Seat:
        return self.by_token[token]

    def __contains__(self, token: str) -> bool:
        return token in self.by_token

    def meet(self, token: str, name: str, needed: Collection[str]) -> None:
        """Notes the name of a seat, a new one too; needed: those that must not be forgotten. token: of the seat."""
        if token in self.by_token:
            if self.by_token[token].name != name:
                self.by_token[token] = replace(self.by_token[token], name=name)
            return
        spare = next((candidate for candidate in self.by_token if candidate not in needed), None)
        if len(self.by_token) >= MOST_SEATS and spare is not None:
            del self.by_token[spare]
        number = 1 + max((seat.number for seat in self.by_token.values()), default=0)
        self.by_token[token] = Seat(number, name, self._free_colour(needed))

    def token_of(self, number: int) -> str | None:
        """The token of the seat with a number; None where there is none."""
        return next((token for token, seat in self.by_token.items() if seat.number == number), None)

    def _free_colour(self, needed: Collection[str]) -> str:
        """The colour that fewest seats have: of those that are here, then of all."""
        here = [seat.colour for token, seat in self.by_token.items() if token in needed]
        seen = [seat.colour for seat in self.by_token.values()]
        return min(COLOURS, key=lambda colour: (here.count(colour), seen.count(colour), COLOURS.index(colour)))
