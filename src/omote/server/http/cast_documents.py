"""Serializes the cast's documents; compounds and other costly ones are computed on request, off the show's event
loop."""

from __future__ import annotations

import asyncio
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import msgspec

from omote.builtin import BakedMesh, load_cast, load_mask, load_meshes
from omote.edit.protocol.orders import EditOrder
from omote.interchange.formats.error_reasons import explain_error
from omote.model.cast import Cast
from omote.model.recipes.recipe import KEY
from omote.server.workers.order_scheduler import OrderScheduler
from omote.server.workers.order_worker import (
    CompoundOrder,
    FaceOrder,
    HandlesOrder,
    OrderWorker,
    TangentsOrder,
    WorkshopOrder,
)
from omote.server.workers.workshop import ClosedWorkshopError, FailedOrderError, RefusedOrderError, Workshop
from omote.show.cast_documents import ContentAsset, FaceDocument
from omote.show.objects.state import State
from omote.show.state import names_on_air
from omote.show.wire import encode
from omote.showfile.contents import ContentError
from omote.stage_data.assets import content_name, documents, find_albedo
from omote.stage_data.playing_cast import PlayingCast, build_playing_cast, manifest_of

CACHED_FACES = 256
"""Documents of authored faces that are cached, 60 KB each."""


class CastDocuments:
    """Manifest, assets and compounds of a cast and of the authored faces and expressions beside it, as bytes.

    contents: the bytes of authored contents by key, also of those that do not play; playing: the cast that plays.
    """

    def __init__(self, cast: Cast, meshes: Sequence[BakedMesh], mask: bytes) -> None:
        self.cast = cast
        self.playing = build_playing_cast(cast, (), {})
        self.contents: Mapping[str, bytes] = {}
        self.mask_url = f"/assets/{content_name(mask)}"
        packed = documents(cast, meshes, mask=self.mask_url)
        self._built_in = packed.manifest
        self._manifests = {cast.digest: encode(packed.manifest)}
        self.assets = {url: encode(asset) for url, asset in packed.faces.items()}
        self.assets |= {url: encode(asset) for url, asset in packed.hair.items()}
        self.assets |= {url: encode(asset) for url, asset in packed.figures.items()}
        self.mask = mask
        self._faces: OrderedDict[str, bytes] = OrderedDict()
        self._scheduler = OrderScheduler(self._compound, cast.expressions)
        self.worker = OrderWorker(cast)
        self._workshop: Workshop | None = None
        self._report: Callable[[str], None] = lambda _: None
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="workshop")

    async def manifest(self) -> bytes:
        """The manifest of the cast that plays."""
        return self._manifests.get(self.playing.digest) or await self.prepare(self.playing)

    async def prepare(self, playing: PlayingCast) -> bytes:
        """Makes the manifest of a cast ahead; authored faces that fail are left out and reported to the operator."""
        faces: dict[str, FaceDocument] = {}
        for own in playing.own:
            if own.kind != "face":
                continue
            try:
                data = await self.face(own.content)
            except (KeyError, FailedOrderError, RefusedOrderError) as error:
                self._report(
                    f"the own face {own.label!r} cannot be shown ({explain_error(error)}); pages do not get it."
                )
            else:
                faces[own.content] = msgspec.msgpack.decode(data, type=ContentAsset).face
        loop = asyncio.get_running_loop()
        manifest = await loop.run_in_executor(self._thread, lambda: encode(manifest_of(playing, self._built_in, faces)))
        self._manifests = {self.playing.digest: self._manifests.get(self.playing.digest, b""), playing.digest: manifest}
        return manifest

    def play(self, playing: PlayingCast) -> None:
        """Plays another cast from now on: its compounds are computed ahead."""
        self.playing = playing
        self._scheduler.set_expressions(playing.expression_sources.values())

    async def compound(self, face: str, expression: str) -> bytes:
        """The compound of a face and an expression by their sources; KeyError for an unknown source."""
        self._check(face, self.cast.faces)
        self._check(expression, self.cast.expressions)
        return await self._scheduler.get((face, expression))

    async def face(self, key: str) -> bytes:
        """The `ContentAsset` of an authored face by the key of its content; KeyError where it is missing."""
        if key not in self._faces:
            asset = await self._order(FaceOrder(key, {key: self.contents[key]}))
            self._faces[key] = asset
            while len(self._faces) > CACHED_FACES:
                self._faces.popitem(last=False)
        self._faces.move_to_end(key)
        return self._faces[key]

    async def albedo(self, source: str) -> bytes:
        """The picture on a face's skin, a PNG, by the face's source; KeyError where the face or its picture is
        missing."""
        self._check(source, self.cast.faces)
        loop = asyncio.get_running_loop()
        contents = self._contents(source)
        try:
            return await loop.run_in_executor(None, find_albedo, self.cast, source, contents)
        except ContentError as error:
            raise RefusedOrderError(str(error)) from error

    async def tangents(self, face: str) -> bytes:
        """The `TangentsAsset` of a face by its source; KeyError where it is missing."""
        self._check(face, self.cast.faces)
        return await self._order(TangentsOrder(face, self._contents(face)))

    async def handles(self) -> bytes:
        """The `HandlesAsset`."""
        return await self._order(HandlesOrder())

    async def run_order(self, order: EditOrder) -> bytes:
        """Computes an editor's order; returns its `Baked` answer."""
        return await self._order(order)

    def set_on_air(self, state: State) -> None:
        """Computes first what is on air, then ahead what a face on air may wear next."""
        faces, expressions = names_on_air(state)
        self._scheduler.set_on_air(
            frozenset(source for name, source in self.playing.faces.items() if name in faces),
            frozenset(source for name, source in self.playing.expression_sources.items() if name in expressions),
        )

    def compute(self, order: bytes) -> bytes:
        """Computes an encoded order in this thread and returns the encoded answer."""
        return self.worker.make(order)

    def use_workshop(self, workshop: Workshop | None, report: Callable[[str], None]) -> None:
        """Sends orders to a workshop process from now on, while it lives; report: tells the operator."""
        self._workshop = workshop
        self._report = report

    def close(self) -> None:
        """Stops the scheduler, the workshop and the thread."""
        self._scheduler.close()
        if self._workshop is not None:
            self._workshop.close()
        self._thread.shutdown(wait=False, cancel_futures=True)

    def _order(self, order: WorkshopOrder) -> Awaitable[bytes]:
        return self._scheduler.order(lambda: self._make(order))

    def _compound(self, face: str, expression: str) -> Awaitable[bytes]:
        return self._make(CompoundOrder(face, expression, self._contents(face, expression)))

    async def _make(self, order: WorkshopOrder) -> bytes:
        data = encode(order)
        if self._workshop is not None:
            try:
                return await self._workshop.make(data)
            except ClosedWorkshopError as error:
                self._drop_workshop(str(error))
        try:
            return await asyncio.get_running_loop().run_in_executor(self._thread, self.compute, data)
        except ValueError as error:
            raise RefusedOrderError(str(error)) from error

    def _check(self, source: str, built_in: Mapping[str, object]) -> None:
        """Raises KeyError for a source that names nothing."""
        _ = self.contents[source.removeprefix(KEY)] if source.startswith(KEY) else built_in[source]

    def _contents(self, *sources: str) -> dict[str, bytes]:
        keys = (source.removeprefix(KEY) for source in sources if source.startswith(KEY))
        return {key: self.contents[key] for key in keys}

    def _drop_workshop(self, reason: str) -> None:
        if self._workshop is not None:
            self._workshop.close()
            self._workshop = None
        self._report(f"{reason}; the server computes by itself.")


def built_in_documents() -> CastDocuments:
    """The documents of the baked cast; FileNotFoundError, with how to bake it, when it is missing."""
    return CastDocuments(load_cast(), load_meshes(), load_mask())
