"""Documents of the cast over real sockets."""

from dataclasses import replace
from urllib.parse import quote

import msgspec
import numpy as np
import pytest

from omote.interchange.formats.png import read_png
from omote.model.albedo import Albedo
from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments
from omote.server.http.document_routes import CACHE_FOREVER
from omote.server.workers.workshop import FailedOrderError
from omote.show.cast_documents import CompoundAsset, ContentAsset, FaceAsset, Manifest
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_face
from omote.stage_data.assets import compound_asset, rest_positions
from tests.server.conftest import ShowHarness, state
from tests.server.synthetic_server import MASK

pytestmark = pytest.mark.asyncio


async def test_the_documents_lead_to_one_another(show_harness: ShowHarness, cast: Cast) -> None:
    response = await show_harness.client.get("/manifest")
    manifest = msgspec.msgpack.decode(await response.read(), type=Manifest)
    assert manifest.digest == cast.digest
    again = await show_harness.client.get("/manifest", headers={"If-None-Match": response.headers["ETag"]})
    assert again.status == 304
    for face in manifest.faces:
        asset = await show_harness.client.get(face.url)
        assert asset.headers["Cache-Control"] == CACHE_FOREVER
        packed = msgspec.msgpack.decode(await asset.read(), type=FaceAsset)
        assert packed.positions == rest_positions(cast, cast.faces[face.name]).tobytes()
    mask = await show_harness.client.get(manifest.mask)
    assert (mask.content_type, await mask.read()) == ("image/png", MASK)


async def test_a_compound_comes_from_its_address(show_harness: ShowHarness, cast: Cast) -> None:
    response = await show_harness.client.get(f"/compounds/{cast.digest}/broad/smile")
    assert response.headers["Cache-Control"] == CACHE_FOREVER
    asset = msgspec.msgpack.decode(await response.read(), type=CompoundAsset)
    assert asset == compound_asset(cast, cast.faces["broad"], "smile")


@pytest.mark.parametrize(
    "path", ["/compounds/{}/nobody/smile", "/compounds/{}/broad/nothing", "/compounds/00/broad/smile"]
)
async def test_what_the_cast_has_not_is_not_found(show_harness: ShowHarness, cast: Cast, path: str) -> None:
    response = await show_harness.client.get(path.format(cast.digest))
    assert response.status == 404
    assert "load /manifest again" in await response.text()


async def test_a_picture_of_skin_comes_from_its_address(show_harness: ShowHarness, cast: Cast) -> None:
    texels = np.random.default_rng(1).integers(0, 256, (1024, 1024, 4), np.uint8)
    albedo = Albedo(texels)
    data = pack_face(cast.faces["broad"], replace(cast.looks["broad"], albedo=albedo))
    key = content_key(data)
    documents = show_harness.show.documents
    documents.contents = {**documents.contents, key: data}
    made = await show_harness.client.get(f"/contents/{key}")
    face = msgspec.msgpack.decode(await made.read(), type=ContentAsset).face
    assert face.albedo == albedo.digest
    response = await show_harness.client.get(f"/albedos/{face.albedo}/{quote(face.source, safe='')}")
    assert (response.content_type, response.headers["Cache-Control"]) == ("image/png", CACHE_FOREVER)
    np.testing.assert_array_equal(read_png(await response.read()), texels)


@pytest.mark.parametrize("source", ["broad", "nobody", "%23abc"])
async def test_a_face_without_a_picture_has_none(show_harness: ShowHarness, source: str) -> None:
    response = await show_harness.client.get(f"/albedos/00/{source}")
    assert response.status == 404


async def test_a_compound_that_cannot_be_computed_now_may_be_asked_for_again(
    show_harness: ShowHarness, cast: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def failing(self: CastDocuments, face: str, expression: str) -> bytes:
        raise FailedOrderError("broad wearing smile cannot be computed")

    monkeypatch.setattr(CastDocuments, "compound", failing)
    response = await show_harness.client.get(f"/compounds/{cast.digest}/broad/smile")
    assert response.status == 503
    assert "cannot be computed" in await response.text()


async def test_a_compound_that_is_being_computed_holds_up_no_state(
    show_harness: ShowHarness, cast: Cast, monkeypatch: pytest.MonkeyPatch
) -> None:
    link = await show_harness.link()
    documents = show_harness.show.documents
    waiting: list[str] = []

    async def slow(self: CastDocuments, face: str, expression: str) -> bytes:
        waiting.append(face)
        show_harness.tick()
        assert (await state(link)).number == len(waiting)
        return expression.encode()

    monkeypatch.setattr(CastDocuments, "compound", slow)
    assert isinstance(documents, CastDocuments)
    response = await show_harness.client.get(f"/compounds/{cast.digest}/broad/smile")
    assert await response.read() == b"smile"
    assert waiting == ["broad"]
