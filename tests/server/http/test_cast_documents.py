"""The documents of a cast, ready to send."""

import asyncio
import os
import signal

import msgspec
import pytest

from omote.model.cast import Cast
from omote.server.http.cast_documents import CastDocuments, built_in_documents
from omote.server.workers import order_worker as worker
from omote.server.workers.order_worker import CompoundOrder
from omote.server.workers.workshop import open_workshop
from omote.show.cast_documents import CompoundAsset, Manifest
from omote.show.session import ShowSession
from omote.show.wire import encode
from tests.server.synthetic_server import MASK, meshes


@pytest.fixture
def documents(cast: Cast) -> CastDocuments:
    """The synthetic cast's."""
    return CastDocuments(cast, meshes(cast), MASK)


def ask(documents: CastDocuments, *pairs: tuple[str, str]) -> list[bytes]:
    """The compounds of these faces and expressions."""

    async def all_of_them() -> list[bytes]:
        return [await documents.compound(*pair) for pair in pairs]

    return asyncio.run(all_of_them())


def alone(documents: CastDocuments, face: str, expression: str) -> bytes:
    """A compound, here and now."""
    return documents.compute(encode(CompoundOrder(face, expression, {})))


def test_a_compound_is_computed_once(documents: CastDocuments, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = ask(documents, ("broad", "smile"), ("long", "smile"))
    monkeypatch.setattr(worker, "compound_asset", None)
    assert ask(documents, ("broad", "smile"), ("long", "smile")) == [first, second]
    assert first != second
    msgspec.msgpack.decode(first, type=CompoundAsset)
    documents.close()


def test_a_face_that_is_called_is_computed_in_full(documents: CastDocuments, monkeypatch: pytest.MonkeyPatch) -> None:
    session = ShowSession(documents.cast, epoch=1)
    session.scene["one"].call_face("broad")
    state = session.tick(0.0)

    async def all_of_it() -> list[bytes]:
        documents.set_on_air(state)
        return [await documents.compound("broad", name) for name in reversed(list(documents.cast.expressions))]

    assert asyncio.run(all_of_it()) == [
        alone(documents, "broad", name) for name in reversed(list(documents.cast.expressions))
    ]
    monkeypatch.setattr(worker, "compound_asset", None)
    ask(documents, *(("broad", name) for name in documents.cast.expressions))
    documents.close()


def test_a_workshop_computes_the_same(documents: CastDocuments) -> None:
    expected = alone(documents, "broad", "smile")
    said: list[str] = []
    documents.use_workshop(open_workshop(documents.compute), said.append)

    async def together() -> tuple[bytes, bytes]:
        made = await documents.compound("broad", "smile")
        assert documents._workshop is not None
        os.kill(documents._workshop.supervisor_pid, signal.SIGKILL)
        other = await documents.compound("long", "smile")
        documents.close()
        return made, other

    assert asyncio.run(together()) == (expected, alone(documents, "long", "smile"))
    assert said == ["the process that computes beside the show is gone; the server computes by itself."]


@pytest.mark.parametrize("pair", [("nobody", "smile"), ("broad", "nothing")])
def test_names_that_the_cast_has_not_are_refused(documents: CastDocuments, pair: tuple[str, str]) -> None:
    with pytest.raises(KeyError):
        ask(documents, pair)


def test_every_address_of_the_manifest_is_there(documents: CastDocuments) -> None:
    manifest = msgspec.msgpack.decode(asyncio.run(documents.manifest()), type=Manifest)
    assert manifest.figures is not None
    bodies = {body.url for body in manifest.figures.bodies}
    assert {face.url for face in manifest.faces} | bodies | {manifest.figures.url} == set(documents.assets)
    assert manifest.mask == documents.mask_url


def test_the_built_in_cast_has_documents() -> None:
    manifest = msgspec.msgpack.decode(asyncio.run(built_in_documents().manifest()), type=Manifest)
    assert [mesh.name for mesh in manifest.meshes] == [
        "skin", "eye_left", "eye_right", "teeth_upper", "teeth_lower", "tongue", "lashes",
    ]  # fmt: skip
    assert len(manifest.faces) >= 8
