"""The bones of a figure: names, what hangs on what, and which of them make a limb."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np

from omote.arrays import Indices
from omote.geometry.mesh import freeze

SIDES = ("L", "R")
TRUNK = ("root", "spine05", "spine04", "spine03", "spine02", "spine01", "neck01", "neck02", "neck03", "head")
"""From the hips up, each the parent of the next."""
ARM = ("clavicle", "shoulder01", "upperarm01", "upperarm02", "lowerarm01", "lowerarm02", "wrist")
LEG = ("pelvis", "upperleg01", "upperleg02", "lowerleg01", "lowerleg02", "foot", "toes")
"""Of one side, each the parent of the next; a limb's second bone lies along its first and takes a part of its twist."""


@dataclass(frozen=True, eq=False)
class Skeleton:
    """Bones in an order in which a parent stands before its children.

    Parameters
    ----------
    names : tuple of str
        Of the J bones; those of a side end with .L or .R.
    parents : array_like of int, (J,)
        The place of the bone that each hangs on; -1 for the first, which hangs on nothing.

    Raises
    ------
    ValueError
        Where a name comes twice, or a parent does not stand before its child.
    """

    names: tuple[str, ...]
    parents: Indices

    def __post_init__(self) -> None:
        parents = np.asarray(self.parents, np.int32)
        count = len(self.names)
        if len(set(self.names)) != count or parents.shape != (count,):
            raise ValueError(f"a skeleton has {count} names and {parents.shape} parents; expected one parent for each")
        if count == 0 or parents[0] != -1 or not ((parents[1:] >= 0) & (parents[1:] < np.arange(1, count))).all():
            raise ValueError(f"the parents of a skeleton are {parents.tolist()}; expected each before its children")
        object.__setattr__(self, "parents", freeze(parents))

    @cached_property
    def places(self) -> Mapping[str, int]:
        """The place of each bone, by its name."""
        return MappingProxyType({name: place for place, name in enumerate(self.names)})

    @cached_property
    def mirror(self) -> Indices:
        """The place (J,) of each bone's mirror image; a bone in the middle is its own."""
        other = {".L": ".R", ".R": ".L"}
        names = (name[:-2] + other.get(name[-2:], name[-2:]) for name in self.names)
        return freeze(np.array([self.places[name] for name in names], np.int32))
