"""A pad: two to twelve looks at places of a line, a square or a cube, and their mixture at any point among them."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Literal, get_args

import numpy as np

from omote.arrays import Values
from omote.perform.limits import check_known, check_within
from omote.perform.mix import Weights, combine

PadPart = Literal["face", "expression", "brows", "eyes", "mouth", "rest", "pose"]
"""What a pad plays: the faces, the expressions of the whole face or of one region of it, or the poses of the figure."""
PAD_PARTS: tuple[PadPart, ...] = get_args(PadPart)
PadPlace = tuple[float, ...]
"""A number for each dimension, as far as a stick goes."""
AXES = ("x", "y", "z")
_NUMBERS = tuple(f"{axis} of a pad" for axis in AXES)
PLACE_RANGE = (-1.0, 1.0)
FEWEST_LOOKS = 2
MOST_LOOKS = 12
LEAST_APART = 0.06
"""Between the places of two looks; .03 of the way from one end of a stick to the other. Nearer than that a finger does
not tell them apart, and weights move fast between them."""
MOST_PADS = 32
"""Of a show."""
MOST_NAMES = 24
"""Names in the mix of a look."""
LONGEST_PAD_NAME = 24
LONGEST_LOOK_LABEL = 40
ROUNDING = 1e-6
"""How far the weights of a look may be from 1 together."""
_IN_NO_NAME = " /*?[]{}#,:"
"""What parts and patterns of OSC addresses are made of, and goals of cues."""


@dataclass(frozen=True)
class PadLook:
    """What a pad shows at one place.

    Parameters
    ----------
    label : str
        What people read there, 1 to 40 letters.
    mix : mapping of float
        Weights by name, 0 to 1, together 1: of expressions, of faces or poses where the pad plays those.
    place : tuple of float
        A number for each dimension of the pad, -1 to 1.

    Raises
    ------
    ValueError
        On a label, a weight or a place that none can have.
    TypeError
        On what is no number.

    Examples
    --------
    >>> omote.PadLook("Smile", {"smile": 1.0}, (0.5, 0.5)).place
    (0.5, 0.5)

    References
    ----------
    docs/method.md, "Pads".
    """

    label: str
    mix: Weights
    place: PadPlace

    def __post_init__(self) -> None:
        """Rejects what no look can be."""
        label = self.label.strip() if isinstance(self.label, str) else ""
        if not 0 < len(label) <= LONGEST_LOOK_LABEL:
            raise ValueError(f"the label of a look is {self.label!r:.100}; give 1 to {LONGEST_LOOK_LABEL} letters")
        object.__setattr__(self, "label", label)
        object.__setattr__(self, "mix", _check_mix(self.mix, label))
        place = tuple(check_within(at, *PLACE_RANGE, f"the place of {label}") for at in self.place)
        object.__setattr__(self, "place", place)


@dataclass(frozen=True)
class Pad:
    """A blend space: looks at places, and their mixture wherever a point is moved among them.

    At a look it shows that look alone, whatever lies around it.

    Parameters
    ----------
    name : str
        1 to 24 letters, no spaces: it stands in addresses of OSC.
    part : {"face", "expression", "brows", "eyes", "mouth", "rest"}
        What it plays: the faces, the expressions of the whole face, or those of one region of it.
    dimensions : int
        1, 2 or 3.
    looks : sequence of PadLook
        2 to 12, their places at least 0.06 apart, no two of one label.

    Raises
    ------
    ValueError
        On a name, a part or a number that no pad can have, and on looks that are too few, too many or too near.
    TypeError
        On what is no look.

    Examples
    --------
    >>> calm = omote.PadLook("Calm", {"neutral": 1.0}, (-1.0,))
    >>> glad = omote.PadLook("Glad", {"joy": 1.0}, (1.0,))
    >>> omote.Pad("mood", "expression", 1, [calm, glad]).mix_at((0.0,))
    {'neutral': 0.5, 'joy': 0.5}

    References
    ----------
    docs/method.md, "Pads".
    """

    name: str
    part: PadPart
    dimensions: int
    looks: tuple[PadLook, ...]

    def __post_init__(self) -> None:
        """Rejects what no pad can be."""
        check_pad_name(self.name)
        check_known(self.part, PAD_PARTS, "part that a pad plays")
        if self.dimensions not in (1, 2, 3):
            raise ValueError(f"the pad {self.name} has {self.dimensions!r:.20} dimensions; expected 1, 2 or 3")
        looks = tuple(self.looks)
        if not FEWEST_LOOKS <= len(looks) <= MOST_LOOKS:
            raise ValueError(
                f"the pad {self.name} has {len(looks)} looks; a pad has {FEWEST_LOOKS} to {MOST_LOOKS} of them"
            )
        for look in looks:
            if not isinstance(look, PadLook):
                raise TypeError(f"a look of the pad {self.name} is a {type(look).__name__}; give omote.PadLook")
            if len(look.place) != self.dimensions:
                raise ValueError(
                    f"the place of {look.label} has {len(look.place)} numbers; the pad {self.name} has "
                    f"{self.dimensions} dimensions, give as many"
                )
        _check_apart(looks, self.name)
        object.__setattr__(self, "looks", looks)

    def weights_at(self, place: Sequence[float]) -> list[float]:
        """How much of each look shows at a point.

        Parameters
        ----------
        place : sequence of float
            A number for each dimension, -1 to 1.

        Returns
        -------
        list of float
            In the order of the looks, each 0 to 1, together 1.

        Raises
        ------
        ValueError
            On a place that is none of this pad.
        TypeError
            On what is no number.

        Examples
        --------
        >>> looks = [omote.PadLook(name, {name: 1.0}, (at,)) for name, at in (("neutral", 0), ("joy", 1))]
        >>> omote.Pad("mood", "expression", 1, looks).weights_at((0.5,))
        [0.5, 0.5]
        """
        return self._weights(self.check_place(place))

    def mix_at(
        self, place: Sequence[float], known: Container[str] | None = None, *, instead: str = ""
    ) -> dict[str, float]:
        """The mixture of the looks at a point.

        Parameters
        ----------
        place : sequence of float
            As of `weights_at`.
        known : container of str, optional
            The names that there are; what is not among them counts as `instead`. All are there without it.
        instead : str
            The name that a lost one counts as.

        Returns
        -------
        dict of float
            Weights by name, together 1.

        Raises
        ------
        ValueError
            On a place that is none of this pad.
        TypeError
            On what is no number.

        Examples
        --------
        >>> looks = [omote.PadLook(name, {name: 1.0}, (at,)) for name, at in (("lost", -1), ("neutral", 0), ("joy", 1))]
        >>> omote.Pad("mood", "expression", 1, looks).mix_at((-1,), cast.expressions, instead="neutral")
        {'neutral': 1.0}
        """
        return mix_of_place(self, self.check_place(place), known, instead=instead)

    def check_place(self, place: Sequence[float]) -> PadPlace:
        """Returns a place of this pad.

        Parameters
        ----------
        place : sequence of float
            As of `weights_at`.

        Returns
        -------
        tuple of float
            The same.

        Raises
        ------
        ValueError
            On too many or too few numbers, and on one out of range.
        TypeError
            On what is no number.

        Examples
        --------
        >>> looks = [omote.PadLook(name, {name: 1.0}, (at,)) for name, at in (("neutral", 0), ("joy", 1))]
        >>> omote.Pad("mood", "expression", 1, looks).check_place([1])
        (1.0,)
        """
        if len(place) != self.dimensions:
            raise ValueError(
                f"{len(place)} numbers came for the pad {self.name}, which has {self.dimensions} dimensions; give "
                f"{', '.join(AXES[: self.dimensions])}"
            )
        low, high = PLACE_RANGE
        return tuple([check_within(at, low, high, what) for at, what in zip(place, _NUMBERS, strict=False)])

    def moved(self, place: PadPlace, x: float | None, y: float | None, z: float | None) -> PadPlace:
        """A place of this pad with other numbers.

        Parameters
        ----------
        place : tuple of float
            Where its point is.
        x, y, z : float, optional
            Where it goes, -1 to 1; what is not given stays.

        Returns
        -------
        tuple of float
            A number for each dimension.

        Raises
        ------
        ValueError
            On a number out of range and on one of a dimension that the pad does not have.
        TypeError
            On what is no number.

        Examples
        --------
        >>> looks = [omote.PadLook(name, {name: 1.0}, (at, 0)) for name, at in (("neutral", 0), ("joy", 1))]
        >>> omote.Pad("mood", "expression", 2, looks).moved((0.0, 0.5), 1.0, None, None)
        (1.0, 0.5)
        """
        given = (x, y, z)
        if any(at is not None for at in given[self.dimensions :]):
            raise ValueError(
                f"the pad {self.name} has {self.dimensions} dimensions and no {AXES[self.dimensions]}; give "
                f"{', '.join(AXES[: self.dimensions])}"
            )
        own = fitted(place, self.dimensions)
        return self.check_place([own[n] if at is None else at for n, at in enumerate(given[: self.dimensions])])

    def lost(self, known: Container[str]) -> list[str]:
        """The names of its looks that there are not.

        Parameters
        ----------
        known : container of str
            Those that there are.

        Returns
        -------
        list of str
            Each once.

        Examples
        --------
        >>> looks = [omote.PadLook(name, {name: 1.0}, (at,)) for name, at in (("lost", 0), ("joy", 1))]
        >>> omote.Pad("mood", "expression", 1, looks).lost(cast.expressions)
        ['lost']
        """
        return list(dict.fromkeys(name for look in self.looks for name in look.mix if name not in known))

    @cached_property
    def _mixes(self) -> tuple[Weights, ...]:
        return tuple(look.mix for look in self.looks)

    @cached_property
    def _places(self) -> Values:
        """The places of the looks (n, 3); a dimension that the pad does not have is 0."""
        places = np.zeros((len(self.looks), len(AXES)))
        places[:, : self.dimensions] = [look.place for look in self.looks]
        places.flags.writeable = False
        return places

    def _weights(self, place: PadPlace) -> list[float]:
        out = np.empty(len(self.looks))
        x, y, z = (*place, 0.0, 0.0)[:3]
        _soft_bands()(self._places, x, y, z, out)
        weights: list[float] = out.tolist()
        return weights


def mix_of_place(
    pad: Pad, place: PadPlace, known: Container[str] | None = None, *, instead: str = ""
) -> dict[str, float]:
    """The mixture of the looks of a pad at a place of it, as of `Pad.mix_at`. place: checked; known: the names that
    there are; instead: what others count as."""
    mix = combine(zip(pad._weights(place), pad._mixes, strict=True))
    if known is None or all(map(known.__contains__, mix)):
        return mix
    return combine((1.0, {name if name in known else instead: weight}) for name, weight in mix.items())


@cache
def _soft_bands() -> Callable[..., None]:
    """The kernel, loaded when a first point is moved: Numba takes a third of a second, and most programs need none."""
    from omote.perform.pads.soft_bands import soft_bands

    return soft_bands


def fitted(place: Iterable[float], dimensions: int) -> PadPlace:
    """A place in so many dimensions: what it has not is 0, what it has beyond goes."""
    return (*place, 0.0, 0.0, 0.0)[:dimensions]


def check_pad_name(name: object) -> str:
    """Returns the name of a pad; ValueError for one that no address can have."""
    if not isinstance(name, str) or not 0 < len(name) <= LONGEST_PAD_NAME:
        raise ValueError(f"the name of a pad is {name!r:.100}; give 1 to {LONGEST_PAD_NAME} letters")
    wrong = next((letter for letter in name if letter in _IN_NO_NAME or not letter.isprintable()), None)
    if wrong is not None:
        raise ValueError(
            f"a pad cannot be named {name!r}, for {wrong!r} has a meaning in addresses; leave it out, or write - for it"
        )
    return name


def _check_mix(mix: object, label: str) -> dict[str, float]:
    if not isinstance(mix, Mapping) or not 0 < len(mix) <= MOST_NAMES:
        raise ValueError(f"the look {label} is {mix!r:.80}; give the weights of 1 to {MOST_NAMES} names")
    checked = {str(name): check_within(weight, 0.0, 1.0, f"{name} in {label}") for name, weight in mix.items()}
    total = math.fsum(checked.values())
    if not abs(total - 1.0) <= ROUNDING:
        raise ValueError(f"the weights of the look {label} sum to {total:g}; they must sum to 1")
    return checked


def _check_apart(looks: Sequence[PadLook], name: str) -> None:
    """Rejects looks of one label, and places that are too near to one another."""
    for place, look in enumerate(looks):
        for other in looks[:place]:
            if other.label.casefold() == look.label.casefold():
                raise ValueError(f"two looks of the pad {name} are called {look.label!r}; give one another label")
            apart = math.dist(other.place, look.place)
            if apart < LEAST_APART:
                raise ValueError(
                    f"{other.label} and {look.label} on the pad {name} are {apart:.3g} apart; move them {LEAST_APART} "
                    "apart or farther"
                )
