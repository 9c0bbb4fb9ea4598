"""Compounds on demand: each computed once per cast and kept while there is room."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from typing import Literal
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from omote.model.transfer.compound import compound, compound_parts, generic_face
from omote.model.transfer.corrective_regions import settling_of
from omote.perform.blending.correctives import allowance

Floats = NDArray[np.float32]
What = Literal["skin", "parts", "allowance"]

ROOM = 512 * 2**20
"""Bytes of compounds kept per cast; the least recently used go first."""


class Compounds:
    """The compounds of one cast, remembered: skins (V, 3) and parts (n, 3) by face and expression, metres."""

    def __init__(self, cast: Cast, *, room: int = ROOM) -> None:
        self._faces = cast.faces
        self._expressions = cast.expressions
        self._space = cast.space
        self._room = room
        self._kept: OrderedDict[tuple[str, str, What], Mapping[str, Floats]] = OrderedDict()
        self._bytes = 0

    def skin(self, face: str, expression: str) -> Floats:
        """The compound's skin and inner skin (V, 3)."""
        return self._get(face, expression, "skin")[""]

    def source(self, expression: str) -> Floats:
        """The generic face's compound (V, 3), by the paper's map."""
        return self._get("", expression, "skin")[""]

    def parts(self, face: str, expression: str) -> Mapping[str, Floats]:
        """The compound's parts by name, each (n, 3); eyeballs before their turn."""
        return self._get(face, expression, "parts")

    def allowance(self, face: str, expression: str) -> Floats:
        """What the compound alone uses up (omote.perform.blending.correctives); empty without correctives."""
        return self._get(face, expression, "allowance")[""]

    def _get(self, face: str, expression: str, what: What) -> Mapping[str, Floats]:
        key = (face, expression, what)
        if key not in self._kept:
            self._keep(key, self._made(face, expression, what))
        self._kept.move_to_end(key)
        return self._kept[key]

    def _made(self, face: str, expression: str, what: What) -> Mapping[str, Floats]:
        worn = self._expressions[expression]
        wearer = self._faces[face] if face else generic_face(self._space)
        if what == "parts":
            return compound_parts(self._space, wearer, worn)
        if what == "skin":
            return {"": compound(self._space, wearer, worn)}
        settling, skin = settling_of(self._space), self.skin(face, expression)
        if settling is None:
            return {"": np.empty(0, np.float32)}
        return {"": allowance(settling, fit(self._space, wearer), worn, skin)}

    def _keep(self, key: tuple[str, str, What], arrays: Mapping[str, Floats]) -> None:
        self._kept[key] = arrays
        self._bytes += _size(arrays)
        while self._bytes > self._room and len(self._kept) > 1:
            _, dropped = self._kept.popitem(last=False)
            self._bytes -= _size(dropped)


_of_cast: WeakKeyDictionary[Cast, Compounds] = WeakKeyDictionary()


def compounds_of(cast: Cast) -> Compounds:
    """The compounds of a cast, the same ones as long as the cast lives."""
    if cast not in _of_cast:
        _of_cast[cast] = Compounds(cast)
    return _of_cast[cast]


def _size(arrays: Mapping[str, Floats]) -> int:
    return sum(array.nbytes for array in arrays.values())
