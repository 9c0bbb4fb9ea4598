"""Serves the documents of the cast; the address of a costly one names its content, so browsers keep it for ever."""

from __future__ import annotations

from collections.abc import Awaitable, Callable

from aiohttp import web

from omote.server.http.cast_documents import CastDocuments
from omote.server.workers.workshop import FailedOrderError, RefusedOrderError

CACHE_FOREVER = "public, max-age=31536000, immutable"
NO_CACHE = "no-cache"
MESSAGEPACK = "application/msgpack"


class DocumentRoutes:
    """Answers for the documents of a cast."""

    def __init__(self, documents: CastDocuments) -> None:
        self.documents = documents

    def add_routes(self, application: web.Application) -> None:
        """Adds the addresses of all documents."""
        application.router.add_get("/manifest", self.manifest)
        application.router.add_get("/assets/{name}", self.asset)
        application.router.add_get("/compounds/{base}/{face}/{expression}", self.compound)
        application.router.add_get("/tangents/{base}/{face}", self.tangents)
        application.router.add_get("/handles", self.handles)
        application.router.add_get("/contents/{key}", self.content)
        application.router.add_get("/albedos/{digest}/{source}", self.albedo)

    async def manifest(self, request: web.Request) -> web.Response:
        """Responds with the manifest of the cast."""
        tag = f'"{self.documents.playing.digest}"'
        headers = {"Cache-Control": NO_CACHE, "ETag": tag}
        if request.headers.get("If-None-Match") == tag:
            return web.Response(status=304, headers=headers)
        return web.Response(body=await self.documents.manifest(), content_type=MESSAGEPACK, headers=headers)

    async def asset(self, request: web.Request) -> web.Response:
        """Responds with a face, a hair style or the mask picture, by the digest of its content."""
        kept = {"Cache-Control": CACHE_FOREVER}
        if request.path == self.documents.mask_url:
            return web.Response(body=self.documents.mask, content_type="image/png", headers=kept)
        data = self.documents.assets.get(request.path)
        if data is None:
            raise web.HTTPNotFound(text="there is no such asset in this cast: load /manifest again.")
        return web.Response(body=data, content_type=MESSAGEPACK, headers=kept)

    async def compound(self, request: web.Request) -> web.Response:
        """Responds with the compound of a face and an expression, by their sources."""
        names = request.match_info
        return await self._respond_computed(
            request, lambda: self.documents.compound(names["face"], names["expression"])
        )

    async def tangents(self, request: web.Request) -> web.Response:
        """Responds with the tangents of a face (its derivative with respect to a field), by its source."""
        return await self._respond_computed(request, lambda: self.documents.tangents(request.match_info["face"]))

    async def handles(self, request: web.Request) -> web.Response:
        """Responds with the handles of the face editor."""
        return await self._respond_computed(request, self.documents.handles, keep=NO_CACHE)

    async def content(self, request: web.Request) -> web.Response:
        """Responds with an authored face, by the key of its content."""
        return await self._respond_computed(request, lambda: self.documents.face(request.match_info["key"]))

    async def albedo(self, request: web.Request) -> web.Response:
        """Responds with the picture on a face's skin, a PNG, by the face's source."""
        source = request.match_info["source"]
        return await self._respond_computed(request, lambda: self.documents.albedo(source), kind="image/png")

    async def _respond_computed(
        self,
        request: web.Request,
        make: Callable[[], Awaitable[bytes]],
        keep: str = CACHE_FOREVER,
        kind: str = MESSAGEPACK,
    ) -> web.Response:
        """Responds with what `make` computes; by default cacheable for ever, for the address names the content."""
        if request.match_info.get("base", self.documents.cast.digest) != self.documents.cast.digest:
            raise web.HTTPNotFound(text="the cast has changed: load /manifest again.")
        try:
            data = await make()
        except KeyError as error:
            raise web.HTTPNotFound(text=f"there is no {str(error)[:80]} in this cast: load /manifest again.") from error
        except RefusedOrderError as error:
            raise web.HTTPNotFound(text=f"{error}.") from error
        except FailedOrderError as error:
            raise web.HTTPServiceUnavailable(text=f"{error}.") from error
        return web.Response(body=data, content_type=kind, headers={"Cache-Control": keep})
