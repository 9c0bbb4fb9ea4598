"""The cast's documents as bytes, ready to send; what takes mathematics is made when asked for, beside the show's
loop."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import msgspec

from omote.builtin import BakedMesh, load_cast, load_mask, load_meshes
from omote.edit.protocol.orders import EditOrder
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY
from omote.server.workers.order_scheduler import Supply
from omote.server.workers.order_worker import Bench, CompoundOrder, FaceOrder, HandlesOrder, ShopOrder, TangentsOrder
from omote.server.workers.workshop import ClosedWorkshopError, FailedOrderError, RefusedOrderError, Workshop
from omote.show.messages import ContentAsset, FaceDocument, State
from omote.show.state import names_on_air
from omote.show.wire import encode
from omote.stage_data.assets import content_name, documents
from omote.stage_data.playing_cast import Troupe, manifest_of, troupe_of

KEPT = 256
"""Documents of own faces that are kept, 60 KB each."""


class Library:
    """Manifest, assets and compounds of a cast and of own things beside it.

    contents: the bytes of own things by key, also of those that do not play; troupe: what plays.
    """

    def __init__(self, cast: Cast, meshes: Sequence[BakedMesh], mask: bytes) -> None:
        self.cast, self.troupe = cast, troupe_of(cast, (), {})
        self.contents: Mapping[str, bytes] = {}
        self.mask_url = f"/assets/{content_name(mask)}"
        packed = documents(cast, meshes, mask=self.mask_url)
        self._built_in = packed.manifest
        self._manifests = {cast.digest: encode(packed.manifest)}
        self.assets = {url: encode(asset) for url, asset in packed.faces.items()}
        self.assets |= {url: encode(asset) for url, asset in packed.hair.items()}
        self.mask = mask
        self._faces: OrderedDict[str, bytes] = OrderedDict()
        self._supply = Supply(self._compound, cast.expressions)
        self.bench = Bench(cast)
        self._workshop: Workshop | None = None
        self._report: Callable[[str], None] = lambda _: None
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="workshop")

    async def manifest(self) -> bytes:
        """The manifest of what plays."""
        return self._manifests.get(self.troupe.digest) or await self.prepare(self.troupe)

    async def prepare(self, troupe: Troupe) -> bytes:
        """The manifest of a troupe, made ahead; own faces that cannot be are left out, and the operator is told."""
        found: dict[str, FaceDocument] = {}
        for own in troupe.own:
            if own.kind != "face":
                continue
            try:
                data = await self.face(own.content)
            except (KeyError, FailedOrderError, RefusedOrderError) as error:
                self._report(f"the own face {own.label!r} cannot be shown ({error}); pages do not get it.")
            else:
                found[own.content] = msgspec.msgpack.decode(data, type=ContentAsset).face
        loop = asyncio.get_running_loop()
        manifest = await loop.run_in_executor(self._thread, lambda: encode(manifest_of(troupe, self._built_in, found)))
        self._manifests = {self.troupe.digest: self._manifests.get(self.troupe.digest, b""), troupe.digest: manifest}
        return manifest

    def play(self, troupe: Troupe) -> None:
        """Has what plays made ahead from now on."""
        self.troupe = troupe
        self._supply.stock(troupe.expression_sources.values())

    async def compound(self, face: str, expression: str) -> bytes:
        """The compound of a face and an expression by their sources; KeyError for what is not there."""
        self._check(face, self.cast.faces)
        self._check(expression, self.cast.expressions)
        return await self._supply.get((face, expression))

    async def face(self, key: str) -> bytes:
        """The `ContentAsset` of an own face by the key of its content; KeyError where it is not there."""
        if key not in self._faces:
            made = await self._order(FaceOrder(key, {key: self.contents[key]}))
            self._faces[key] = made
            while len(self._faces) > KEPT:
                self._faces.popitem(last=False)
        self._faces.move_to_end(key)
        return self._faces[key]

    async def tangents(self, face: str) -> bytes:
        """The `TangentsAsset` of a face by its source; KeyError where it is not there."""
        self._check(face, self.cast.faces)
        return await self._order(TangentsOrder(face, self._contents(face)))

    async def handles(self) -> bytes:
        """The `HandlesAsset`."""
        return await self._order(HandlesOrder())

    async def work(self, order: EditOrder) -> bytes:
        """The `Baked` of an editor's order."""
        return await self._order(order)

    def serve(self, state: State) -> None:
        """Makes what is on air first, and ahead what a face on air may wear next."""
        faces, expressions = names_on_air(state)
        self._supply.serve(
            frozenset(source for name, source in self.troupe.faces.items() if name in faces),
            frozenset(source for name, source in self.troupe.expression_sources.items() if name in expressions),
        )

    def compute(self, order: bytes) -> bytes:
        """What an order, as bytes, is answered with, here and now."""
        return self.bench.make(order)

    def employ(self, workshop: Workshop | None, report: Callable[[str], None]) -> None:
        """Has orders made by a workshop from now on, as long as there is one; report: says things to the operator."""
        self._workshop, self._report = workshop, report

    def close(self) -> None:
        """Ends whoever computes."""
        self._supply.close()
        if self._workshop is not None:
            self._workshop.close()
        self._thread.shutdown(wait=False, cancel_futures=True)

    def _order(self, order: ShopOrder) -> Awaitable[bytes]:
        return self._supply.order(lambda: self._make(order))

    def _compound(self, face: str, expression: str) -> Awaitable[bytes]:
        return self._make(CompoundOrder(face, expression, self._contents(face, expression)))

    async def _make(self, order: ShopOrder) -> bytes:
        data = encode(order)
        if self._workshop is not None:
            try:
                return await self._workshop.make(data)
            except ClosedWorkshopError as error:
                self._dismiss_workshop(str(error))
        try:
            return await asyncio.get_running_loop().run_in_executor(self._thread, self.compute, data)
        except ValueError as error:
            raise RefusedOrderError(str(error)) from error

    def _check(self, source: str, built_in: Mapping[str, object]) -> None:
        """KeyError for a source that leads to nothing."""
        _ = self.contents[source.removeprefix(KEY)] if source.startswith(KEY) else built_in[source]

    def _contents(self, *sources: str) -> dict[str, bytes]:
        keys = (source.removeprefix(KEY) for source in sources if source.startswith(KEY))
        return {key: self.contents[key] for key in keys}

    def _dismiss_workshop(self, reason: str) -> None:
        if self._workshop is not None:
            self._workshop.close()
            self._workshop = None
        self._report(f"{reason}; the server computes by itself.")


def built_in() -> Library:
    """The library of the baked cast; FileNotFoundError, with how to bake it, when it is missing."""
    return Library(load_cast(), load_meshes(), load_mask())
