"""The documents of a cast, ready to send."""

import asyncio

import msgspec
import pytest

from omote.model.cast import Cast
from omote.server import library as module
from omote.server.library import Library, built_in
from omote.show.messages import CompoundAsset, Manifest
from tests import synthetic
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


def test_a_compound_is_computed_once(library: Library, monkeypatch: pytest.MonkeyPatch) -> None:
    first, second = ask(library, ("broad", "smile"), ("long", "smile"))
    monkeypatch.setattr(module, "compound_asset", None)
    assert ask(library, ("broad", "smile"), ("long", "smile")) == [first, second]
    assert first != second
    msgspec.msgpack.decode(first, type=CompoundAsset)
    library.close()


@pytest.mark.parametrize("pair", [("nobody", "smile"), ("broad", "nothing")])
def test_names_that_the_cast_has_not_are_refused(library: Library, pair: tuple[str, str]) -> None:
    with pytest.raises(KeyError):
        ask(library, pair)


def test_the_memory_for_compounds_is_bounded(library: Library, monkeypatch: pytest.MonkeyPatch) -> None:
    pairs = [(face, expression) for face in synthetic.FACES for expression in synthetic.EXPRESSIONS]
    limit = 4000
    monkeypatch.setattr(module, "CACHE_BYTES", limit)
    answers = ask(library, *pairs)
    assert sum(map(len, library._compounds.values())) == library._size <= limit + max(map(len, answers))
    assert ask(library, *pairs) == answers
    library.close()


def test_every_address_of_the_manifest_is_there(library: Library) -> None:
    manifest = msgspec.msgpack.decode(library.manifest, type=Manifest)
    assert {face.url for face in manifest.faces} == set(library.assets)
    assert manifest.mask == library.mask_url


def test_the_built_in_cast_has_a_library() -> None:
    manifest = msgspec.msgpack.decode(built_in().manifest, type=Manifest)
    assert [mesh.name for mesh in manifest.meshes] == [
        "skin", "eye_left", "eye_right", "teeth_upper", "teeth_lower", "tongue", "lashes",
    ]  # fmt: skip
    assert len(manifest.faces) >= 8
