"""The documents of a cast, ready to send."""

import asyncio
import os
import signal

import msgspec
import pytest

from omote.model.cast import Cast
from omote.perform.performer import Performer
from omote.server.http.cast_documents import Library, built_in
from omote.server.workers import order_worker as bench
from omote.server.workers.order_worker import CompoundOrder
from omote.server.workers.workshop import open_workshop
from omote.show.messages import CompoundAsset, Manifest
from omote.show.session import ShowSession
from omote.show.wire import encode
from tests.server.synthetic_server import MASK, meshes


@pytest.fixture
def library(cast: Cast) -> Library:
    """The synthetic cast's."""
    return Library(cast, meshes(cast), MASK)


def ask(library: Library, *pairs: tuple[str, str]) -> list[bytes]:
    """The compounds of these faces and expressions."""

    async def all_of_them() -> list[bytes]:
        return [await library.compound(*pair) for pair in pairs]

    return asyncio.run(all_of_them())


def alone(library: Library, face: str, expression: str) -> bytes:
    """A compound, here and now."""
    return library.compute(encode(CompoundOrder(face, expression, {})))


def test_a_compound_is_computed_once(library: Library, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = ask(library, ("broad", "smile"), ("long", "smile"))
    monkeypatch.setattr(bench, "compound_asset", None)
    assert ask(library, ("broad", "smile"), ("long", "smile")) == [first, second]
    assert first != second
    msgspec.msgpack.decode(first, type=CompoundAsset)
    library.close()


def test_a_face_that_is_called_is_computed_in_full(library: Library, monkeypatch: pytest.MonkeyPatch) -> None:
    session = ShowSession(library.cast, Performer(library.cast), epoch=1)
    session.performer.call_face("broad")
    state = session.tick(0.0)

    async def all_of_it() -> list[bytes]:
        library.serve(state)
        return [await library.compound("broad", name) for name in reversed(list(library.cast.expressions))]

    assert asyncio.run(all_of_it()) == [
        alone(library, "broad", name) for name in reversed(list(library.cast.expressions))
    ]
    monkeypatch.setattr(bench, "compound_asset", None)
    ask(library, *(("broad", name) for name in library.cast.expressions))
    library.close()


def test_a_workshop_computes_the_same(library: Library) -> None:
    expected = alone(library, "broad", "smile")
    said: list[str] = []
    library.employ(open_workshop(library.compute), said.append)

    async def together() -> tuple[bytes, bytes]:
        made = await library.compound("broad", "smile")
        assert library._workshop is not None
        os.kill(library._workshop.keeper, signal.SIGKILL)
        other = await library.compound("long", "smile")
        library.close()
        return made, other

    assert asyncio.run(together()) == (expected, alone(library, "long", "smile"))
    assert said == ["the process that computes beside the show is gone; the server computes by itself."]


@pytest.mark.parametrize("pair", [("nobody", "smile"), ("broad", "nothing")])
def test_names_that_the_cast_has_not_are_refused(library: Library, pair: tuple[str, str]) -> None:
    with pytest.raises(KeyError):
        ask(library, pair)


def test_every_address_of_the_manifest_is_there(library: Library) -> None:
    manifest = msgspec.msgpack.decode(asyncio.run(library.manifest()), type=Manifest)
    assert {face.url for face in manifest.faces} == set(library.assets)
    assert manifest.mask == library.mask_url


def test_the_built_in_cast_has_a_library() -> None:
    manifest = msgspec.msgpack.decode(asyncio.run(built_in().manifest()), type=Manifest)
    assert [mesh.name for mesh in manifest.meshes] == [
        "skin", "eye_left", "eye_right", "teeth_upper", "teeth_lower", "tongue", "lashes",
    ]  # fmt: skip
    assert len(manifest.faces) >= 8
