"""The cast's documents as bytes, ready to send; compounds are computed when first asked for, beside the show's loop."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

from omote.builtin import BakedMesh, load_cast, load_mask, load_meshes
from omote.model.cast import Cast
from omote.show.assets import compound_asset, content_name, documents
from omote.show.wire import encode

CACHE_BYTES = 128 << 20
"""Compounds kept in memory."""


class Library:
    """Manifest, assets and compounds of one cast."""

    def __init__(self, cast: Cast, meshes: Sequence[BakedMesh], mask: bytes) -> None:
        self.cast = cast
        self.mask_url = f"/assets/{content_name(mask)}"
        packed = documents(cast, meshes, mask=self.mask_url)
        self.manifest = encode(packed.manifest)
        self.assets = {url: encode(asset) for url, asset in packed.faces.items()}
        self.mask = mask
        self._compounds: OrderedDict[tuple[str, str], bytes] = OrderedDict()
        self._size = 0
        self._worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="compounds")

    async def compound(self, face: str, expression: str) -> bytes:
        """The compound of a face and an expression by name; KeyError for names that the cast has not."""
        key = (face, expression)
        if key not in self._compounds:
            worn, _ = self.cast.faces[face], self.cast.expressions[expression]
            loop = asyncio.get_running_loop()
            self._keep(
                key, encode(await loop.run_in_executor(self._worker, compound_asset, self.cast, worn, expression))
            )
        self._compounds.move_to_end(key)
        return self._compounds[key]

    def close(self) -> None:
        """Ends the worker."""
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _keep(self, key: tuple[str, str], data: bytes) -> None:
        self._size += len(data) - len(self._compounds.get(key, b""))
        self._compounds[key] = data
        while self._size > CACHE_BYTES and len(self._compounds) > 1:
            _, old = self._compounds.popitem(last=False)
            self._size -= len(old)


def built_in() -> Library:
    """The library of the baked cast; FileNotFoundError, with how to bake it, when it is missing."""
    return Library(load_cast(), load_meshes(), load_mask())
