"""Orders as bytes in, what was made of them as bytes out, with all that they need in them."""

import msgspec
import numpy as np
import pytest

from omote.edit.protocol.messages import HandlesAsset, TangentsAsset
from omote.edit.protocol.orders import Bake, Baked
from omote.model.cast import Cast, Look
from omote.model.recipes.recipe import Recipe
from omote.model.space.face import Face
from omote.server.workers import order_worker as module
from omote.server.workers.order_worker import (
    CompoundOrder,
    FaceOrder,
    HandlesOrder,
    OrderWorker,
    TangentsOrder,
    WorkshopOrder,
)
from omote.show.cast_documents import CompoundAsset, ContentAsset
from omote.show.wire import encode
from omote.showfile.changes import content_key
from omote.showfile.contents import pack_expression, pack_face, unpack_expression
from omote.stage_data.assets import compound_asset, content_asset


@pytest.fixture
def worker(cast: Cast) -> OrderWorker:
    """A hand's, with the synthetic cast."""
    return OrderWorker(cast)


def made(worker: OrderWorker, order: WorkshopOrder) -> bytes:
    """What an order is answered with."""
    return worker.make(encode(order))


@pytest.fixture
def face(cast: Cast) -> Face:
    """A face of nobody's cast."""
    return Face("own", (cast.faces["broad"].positions + cast.faces["long"].positions) / 2)


def test_a_compound_of_the_cast_needs_only_names(worker: OrderWorker, cast: Cast) -> None:
    asset = msgspec.msgpack.decode(made(worker, CompoundOrder("broad", "smile", {})), type=CompoundAsset)
    assert asset == compound_asset(cast, cast.faces["broad"], "smile")


def test_a_compound_of_own_things_comes_of_their_bytes(worker: OrderWorker, cast: Cast, face: Face) -> None:
    contents = {
        content_key(data): data for data in (pack_face(face, Look()), pack_expression(cast.expressions["smile"]))
    }
    first, second = contents
    asset = msgspec.msgpack.decode(made(worker, CompoundOrder("#" + first, "#" + second, contents)), type=CompoundAsset)
    assert asset == compound_asset(cast, face, "smile")


def test_a_worker_caches_what_it_unpacked_and_only_so_much(
    worker: OrderWorker, cast: Cast, face: Face, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "CACHED_CONTENTS", 2)
    contents = {
        content_key(data): data
        for data in (pack_face(face, Look(skin=colour)) for colour in ("#000000", "#111111", "#222222"))
    }
    keys = list(contents)
    for key in keys:
        made(worker, CompoundOrder("#" + key, "smile", contents))
    made(worker, CompoundOrder("#" + keys[2], "smile", {}))
    with pytest.raises(ValueError, match="did not come with its order"):
        made(worker, CompoundOrder("#" + keys[0], "smile", {}))


def test_a_face_comes_with_what_pages_must_know_of_it(worker: OrderWorker, cast: Cast, face: Face) -> None:
    data = pack_face(face, Look(skin="#102030"))
    asset = msgspec.msgpack.decode(
        made(worker, FaceOrder(content_key(data), {content_key(data): data})), type=ContentAsset
    )
    assert asset == content_asset(
        cast, content_key(data), Face(content_key(data), face.positions), Look(skin="#102030")
    )
    assert asset.face.source == "#" + content_key(data)


def test_a_face_with_hair_that_the_cast_has_not_is_refused(worker: OrderWorker, face: Face) -> None:
    data = pack_face(face, Look(hair_style="crest"))
    with pytest.raises(ValueError, match="hair 'crest', which this cast has not"):
        made(worker, FaceOrder(content_key(data), {content_key(data): data}))


def test_the_editors_documents_are_made_of_the_cast(worker: OrderWorker, cast: Cast) -> None:
    tangents = msgspec.msgpack.decode(made(worker, TangentsOrder("long", {})), type=TangentsAsset)
    assert len(tangents.tangents) == 3 * 3 * 4 * cast.space.vertex_count
    handles = msgspec.msgpack.decode(made(worker, HandlesOrder()), type=HandlesAsset)
    assert len(handles.points) == len(handles.labels) == len(handles.mirror)


def test_an_editors_order_is_run_by_the_order_runner(worker: OrderWorker) -> None:
    recipe = Recipe(worker.net, ((0.0, 0.001, 1.0),) * len(worker.net))
    baked = msgspec.msgpack.decode(made(worker, Bake(recipe, {})), type=Baked)
    assert baked.recipe == recipe
    field = unpack_expression(baked.contents[baked.key])
    assert np.allclose(field.dh[list(worker.net)], 0.001)


@pytest.mark.parametrize(
    ("wearer", "worn", "sentence"),
    [
        ("nobody", "smile", "there is no face 'nobody' in this cast"),
        ("broad", "nothing", "there is no expression 'nothing' in this cast"),
        ("{expression}", "smile", "is an expression, not a face"),
        ("broad", "{face}", "is a face, not an expression"),
    ],
)
def test_what_is_not_there_or_something_else_is_refused(
    worker: OrderWorker, cast: Cast, face: Face, wearer: str, worn: str, sentence: str
) -> None:
    packed = {"face": pack_face(face, Look()), "expression": pack_expression(cast.expressions["smile"])}
    names = {what: "#" + content_key(data) for what, data in packed.items()}
    contents = {content_key(data): data for data in packed.values()}
    with pytest.raises(ValueError, match=sentence):
        made(worker, CompoundOrder(wearer.format(**names), worn.format(**names), contents))
