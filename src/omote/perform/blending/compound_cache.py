"""Caches compounds: each is computed once per cast and kept while there is room (least recently used goes first)."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping
from typing import Literal

import numpy as np

from omote.arrays import Floats
from omote.model.cast import Cast
from omote.model.space.face_fit import fit, generic_face
from omote.model.transfer.compound import compound, compound_parts
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.model.weak_cache import weakly_cached
from omote.perform.blending.correctives import measure_allowance

What = Literal["skin", "parts", "allowance"]

CAPACITY = 512 * 2**20
"""Bytes of compounds kept per cast; the least recently used go first."""


class CompoundCache:
    """The compounds of one cast, remembered: skins (V, 3) and parts (n, 3) by face and expression, metres."""

    def __init__(self, cast: Cast, *, room: int = CAPACITY) -> None:
        self._faces = cast.faces
        self._expressions = cast.expressions
        self._space = cast.space
        self._room = room
        self._kept: OrderedDict[tuple[str, str, What], Mapping[str, Floats]] = OrderedDict()

    def skin(self, face: str, expression: str) -> Floats:
        """The compound's skin and inner skin (V, 3).

        face, expression: by name.
        """
        return self._get(face, expression, "skin")[""]

    def source(self, expression: str) -> Floats:
        """The generic face's compound (V, 3), by the paper's map."""
        return self._get("", expression, "skin")[""]

    def parts(self, face: str, expression: str) -> Mapping[str, Floats]:
        """The compound's parts by name, each (n, 3); eyeballs before their turn.

        face, expression: by name.
        """
        return self._get(face, expression, "parts")

    def allowance(self, face: str, expression: str) -> Floats:
        """What the compound alone uses up (omote.perform.blending.correctives); empty without corrective regions.

        face, expression: by name.
        """
        return self._get(face, expression, "allowance")[""]

    def _get(self, face: str, expression: str, what: What) -> Mapping[str, Floats]:
        key = (face, expression, what)
        if key not in self._kept:
            self._kept[key] = self._compute(face, expression, what)
            while len(self._kept) > 1 and self._bytes() > self._room:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]

    def _bytes(self) -> int:
        return sum(array.nbytes for arrays in self._kept.values() for array in arrays.values())

    def _compute(self, face_name: str, expression_name: str, what: What) -> Mapping[str, Floats]:
        expression = self._expressions[expression_name]
        face = self._faces[face_name] if face_name else generic_face(self._space)
        if what == "parts":
            return compound_parts(self._space, face, expression)
        if what == "skin":
            return {"": compound(self._space, face, expression)}
        regions = find_corrective_regions(self._space)
        skin = self.skin(face_name, expression_name)
        if regions is None:
            return {"": np.empty(0, np.float32)}
        return {"": measure_allowance(regions, fit(self._space, face), expression, skin)}


@weakly_cached
def compound_cache(cast: Cast) -> CompoundCache:
    """The compounds of a cast, the same ones as long as the cast lives."""
    return CompoundCache(cast)
