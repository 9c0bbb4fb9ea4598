"""The cast's documents as bytes, ready to send; compounds are computed when first asked for, beside the show's loop."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor

from omote.builtin import BakedMesh, load_cast, load_mask, load_meshes
from omote.model.cast import Cast
from omote.server.supply import Supply
from omote.server.workshop import ClosedWorkshopError, Workshop
from omote.show.assets import compound_asset, content_name, documents
from omote.show.messages import State
from omote.show.state import names_on_air
from omote.show.wire import encode


class Library:
    """Manifest, assets and compounds of one cast."""

    def __init__(self, cast: Cast, meshes: Sequence[BakedMesh], mask: bytes) -> None:
        self.cast = cast
        self.mask_url = f"/assets/{content_name(mask)}"
        packed = documents(cast, meshes, mask=self.mask_url)
        self.manifest = encode(packed.manifest)
        self.assets = {url: encode(asset) for url, asset in packed.faces.items()}
        self.assets |= {url: encode(asset) for url, asset in packed.hair.items()}
        self.mask = mask
        self._supply = Supply(self._make, cast.expressions)
        self._workshop: Workshop | None = None
        self._report: Callable[[str], None] | None = None
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="compounds")

    async def compound(self, face: str, expression: str) -> bytes:
        """The compound of a face and an expression by name; KeyError for names that the cast has not."""
        _ = self.cast.faces[face], self.cast.expressions[expression]
        return await self._supply.get((face, expression))

    def serve(self, state: State) -> None:
        """Makes what is on air first, and ahead what a face on air may wear next."""
        self._supply.serve(*names_on_air(state))

    def compute(self, face: str, expression: str) -> bytes:
        """The compound of a face and an expression, here and now."""
        return encode(compound_asset(self.cast, self.cast.faces[face], expression))

    def employ(self, workshop: Workshop, report: Callable[[str], None]) -> None:
        """Has compounds made by a workshop from now on, as long as there is one."""
        self._workshop, self._report = workshop, report

    def close(self) -> None:
        """Ends whoever computes."""
        self._supply.close()
        if self._workshop is not None:
            self._workshop.close()
        self._thread.shutdown(wait=False, cancel_futures=True)

    async def _make(self, face: str, expression: str) -> bytes:
        if self._workshop is not None:
            try:
                return await self._workshop.make(face, expression)
            except ClosedWorkshopError as error:
                self._dismiss_workshop(str(error))
        return await asyncio.get_running_loop().run_in_executor(self._thread, self.compute, face, expression)

    def _dismiss_workshop(self, reason: str) -> None:
        if self._workshop is not None:
            self._workshop.close()
            self._workshop = None
        if self._report is not None:
            self._report(f"{reason}; the server computes them itself.")


def built_in() -> Library:
    """The library of the baked cast; FileNotFoundError, with how to bake it, when it is missing."""
    return Library(load_cast(), load_meshes(), load_mask())
