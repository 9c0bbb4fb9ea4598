"""A doubt about a fit: a sentence of what is not sure, and by its kind what ends it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

DoubtKind = Literal["place", "sides", "eyes", "shape"]
PLACE: DoubtKind = "place"
"""Where the face is: points on it say so."""
SIDES: DoubtKind = "sides"
"""Points that were given have left and right exchanged; what is fitted to them tells nothing."""
EYES: DoubtKind = "eyes"
"""Whether the eyes are shut: a word says so."""
SHAPE: DoubtKind = "shape"
"""What came of it: a look at it, and points where it is off."""


class Doubt(str):
    """A sentence of what is not sure, which is the same for every reader; each place has its own way to end it.

    Parameters
    ----------
    sentence : str
        Of what is not sure, not of what to press.
    kind : DoubtKind
        What it is about.
    """

    kind: DoubtKind

    def __new__(cls, sentence: str, kind: DoubtKind = SHAPE) -> Doubt:
        """The sentence, which knows its kind."""
        made = super().__new__(cls, sentence)
        made.kind = kind
        return made


def join_doubts(place: Iterable[Doubt], fitted: Iterable[Doubt], /) -> tuple[Doubt, ...]:
    """The doubts about where a face is and about what was fitted there, each once; those about points that have their
    sides exchanged alone, for all others follow from it.

    place: about where a face is; fitted: about what was fitted there.
    """
    joined = tuple(dict.fromkeys([*place, *fitted]))
    return tuple(doubt for doubt in joined if doubt.kind == SIDES) or joined
