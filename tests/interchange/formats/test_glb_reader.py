"""Untrusted GLB files: valid ones are parsed, all others are rejected with an error message and allocate nothing."""

from __future__ import annotations

import contextlib
import copy
import struct
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.interchange.formats.glb_reader import read_glb
from tests.interchange.formats.scenes import CORNERS, head_glb, plain_glb, put_together, taken_apart

PLAIN = plain_glb()
Json = dict[str, Any]
HUGE = 2**31


def changed(change: Callable[[Json], object]) -> bytes:
    """The plain file with its JSON changed."""
    document, binary = taken_apart(PLAIN)
    change(document)
    return put_together(document, binary)


def sparse(document: Json) -> Json:
    """The sparse part of the accessor that has one."""
    found: Json = next(accessor["sparse"] for accessor in document["accessors"] if "sparse" in accessor)
    return found


def with_sparse(**places: object) -> bytes:
    """The plain file whose first target is sparse, its places changed."""
    document, binary = taken_apart(PLAIN)
    binary += struct.pack("<HH3f3f", 1, 2, *range(6))
    views = document["bufferViews"]
    at = len(binary) - 28
    views += [{"buffer": 0, "byteOffset": at, "byteLength": 4}, {"buffer": 0, "byteOffset": at + 4, "byteLength": 24}]
    document["buffers"][0]["byteLength"] = len(binary)
    indices = {"bufferView": len(views) - 2, "componentType": 5123} | places
    entry = {"count": places.pop("count", 2), "indices": indices, "values": {"bufferView": len(views) - 1}}
    still = document["meshes"][0]["primitives"][0]["targets"][0]["POSITION"]
    indices.pop("count", None)
    document["accessors"][still]["sparse"] = entry
    return put_together(document, binary)


BOMBS: dict[str, tuple[bytes, str]] = {
    "nothing": (b"", "no GLB"),
    "text": (b"hello, this is no model of anything", "no GLB"),
    "version 1": (PLAIN[:4] + struct.pack("<I", 1) + PLAIN[8:], "glTF 1; expected version 2"),
    "cut short": (PLAIN[:-4], "it is cut short"),
    "a chunk beyond the end": (PLAIN[:12] + struct.pack("<I", HUGE) + PLAIN[16:], "reaches beyond the file"),
    "no JSON first": (PLAIN[:16] + b"NOSJ" + PLAIN[20:], "first chunk is no JSON"),
    "no document": (put_together(b"[]"), "no glTF document"),
    "NaN": (put_together(b'{"nodes":[{"translation":[NaN,0,0]}]}'), "no glTF document"),
    "no end": (put_together(b'{"nodes":[{"translation":[1e999,0,0]}]}'), "no glTF document"),
    "deep": (put_together(b'{"extras":' + b"[" * 100_000 + b"]" * 100_000 + b"}"), "no glTF document"),
    "far too many digits": (put_together(b'{"nodes":[{"mesh":' + b"9" * 5000 + b"}]}"), "no glTF document"),
    "bad text": (put_together(b'{"nodes":[{"name":"\xff"}]}'), "no glTF document"),
    "an accessor of nothing": (
        changed(lambda d: d["accessors"][0].update(count=HUGE) or d["accessors"][0].pop("bufferView")),
        "lays out more than",
    ),
    "a view beyond": (changed(lambda d: d["bufferViews"][0].update(byteLength=HUGE)), "does not hold"),
    "a stride beyond": (changed(lambda d: d["bufferViews"][0].update(byteStride=252)), "does not hold"),
    "a stride too small": (changed(lambda d: d["bufferViews"][0].update(byteStride=4)), "does not hold"),
    "an offset beyond": (changed(lambda d: d["accessors"][0].update(byteOffset=8)), "does not hold"),
    "a negative offset": (changed(lambda d: d["accessors"][0].update(byteOffset=-8)), "no glTF document"),
    "another buffer": (changed(lambda d: d["bufferViews"][0].update(buffer=1)), "does not hold"),
    "a buffer outside": (changed(lambda d: d["buffers"][0].update(uri="../secret.bin")), "lies outside the file"),
    "a second buffer": (changed(lambda d: d["buffers"].append({"byteLength": 4})), "lies outside the file"),
    "a buffer too large": (changed(lambda d: d["buffers"][0].update(byteLength=HUGE)), "the file holds"),
    "an unknown kind": (changed(lambda d: d["accessors"][0].update(componentType=5130)), "none of glTF's"),
    "points of two numbers": (changed(lambda d: d["accessors"][0].update(type="VEC2")), "of 3 numbers"),
    "no accessor": (
        changed(lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(POSITION=999)),
        "accessor 999 and has",
    ),
    "no positions": (
        changed(lambda d: d["meshes"][0]["primitives"][0]["attributes"].pop("POSITION")),
        "positions in accessor -1",
    ),
    "no mesh": (changed(lambda d: d["nodes"][1].update(mesh=7)), "mesh 7"),
    "no node": (changed(lambda d: d["nodes"][0].update(children=[1, 99])), "node 99"),
    "a node twice": (changed(lambda d: d["nodes"][0].update(children=[1, 1])), "hangs under two"),
    "nowhere": (changed(lambda d: d["nodes"][1].update(scale=[1e300] * 3)), "out of all reach"),
    "far off": (changed(lambda d: d["nodes"][1].update(scale=[5e5] * 3)), "stands further off"),
    "a short matrix": (changed(lambda d: d["nodes"][1].update(matrix=[1.0] * 15)), "no glTF document"),
    "compressed": (changed(lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"])), "needs KHR_draco"),
    "too many targets": (
        changed(lambda d: d["meshes"][0]["primitives"][0].update(targets=[{"POSITION": 0}] * 1025)),
        "1024 at most",
    ),
    "rows of parts": (
        changed(lambda d: d["meshes"][0]["primitives"][0]["attributes"].update(_VID=2)),
        "_VID is 4 of 'VEC2'",
    ),
    "sparse places that fall": (with_sparse(byteOffset=0, componentType=5121), "rise within"),
    "sparse places beyond": (with_sparse(byteOffset=4), "does not hold"),
    "sparse places of floats": (with_sparse(componentType=5126), "sparse accessor has"),
    "more sparse than there are": (with_sparse(count=5), "sparse accessor has 5 values of 4"),
}  # fmt: skip


@pytest.mark.parametrize("name", BOMBS)
def test_what_is_wrong_is_refused_with_a_sentence(name: str) -> None:
    data, sentence = BOMBS[name]
    with pytest.raises(ValueError, match=sentence):
        read_glb(data)


def test_a_thousand_accessors_of_one_view_are_not_laid_out() -> None:
    def doubled(document: Json) -> None:
        document["accessors"] = [{"componentType": 5126, "type": "VEC3", "count": 1_000_000}]
        document["meshes"] = [{"primitives": [{"attributes": {"POSITION": 0}}] * 200}]
        document["nodes"] = [{"mesh": 0}]

    with pytest.raises(ValueError, match="lays out more than"):
        read_glb(changed(doubled))


def test_nodes_in_a_circle_show_nothing() -> None:
    assert read_glb(changed(lambda d: d["nodes"][1].update(children=[0]))) == ()


def test_a_sparse_target_is_read() -> None:
    moves = read_glb(with_sparse())[0].moves["still"]
    np.testing.assert_array_equal(moves, [[0, 0, 0], [0, 1, 2], [3, 4, 5], [0, 0, 0]])


def test_places_of_nodes_are_seen_to() -> None:
    def turned(document: Json) -> None:
        document["nodes"][0] |= {"translation": [0, 5, 0], "scale": [2, 2, 2]}
        document["nodes"][1] |= {"rotation": [0, 0, np.sqrt(0.5), np.sqrt(0.5)]}

    plain = read_glb(PLAIN)[0]
    moved = read_glb(changed(turned))[0]
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    np.testing.assert_allclose(moved.points, 2 * plain.points @ quarter.T + [0, 5, 0], atol=1e-12)
    np.testing.assert_allclose(moved.moves["all"], 2 * plain.moves["all"] @ quarter.T, atol=1e-12)
    matrix = [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 3, 0, 0, 1]
    again = read_glb(changed(lambda d: d["nodes"][1].update(matrix=matrix)))[0]
    np.testing.assert_allclose(again.points, plain.points @ quarter.T + [3, 0, 0], atol=1e-12)


def test_whole_numbers_stand_for_parts_of_one() -> None:
    document, _ = taken_apart(head_glb("skin", CORNERS.astype(np.float64), {}))
    document["accessors"][0] |= {"componentType": 5122, "normalized": True}
    document["bufferViews"][0] |= {"byteLength": 24}
    document["buffers"][0]["byteLength"] = 24
    data = np.array([[32767, 0, -32768]] * 4, "<i2").tobytes()
    np.testing.assert_array_equal(read_glb(put_together(document, data))[0].points, [[1.0, 0.0, -1.0]] * 4)


def test_a_target_without_a_name_is_numbered() -> None:
    data = changed(lambda d: d["meshes"][0].pop("extras"))
    assert list(read_glb(data)[0].moves) == ["target_0", "target_1", "target_2"]


@given(st.data())
def test_whatever_is_changed_is_read_or_refused(data: st.DataObject) -> None:
    document, binary = taken_apart(PLAIN)
    document = copy.deepcopy(document)
    where: Any = document
    for _ in range(data.draw(st.integers(1, 5))):
        if not where or not isinstance(where, dict | list):
            break
        key = data.draw(st.sampled_from(sorted(where) if isinstance(where, dict) else range(len(where))))
        inside = where[key]
        if isinstance(inside, dict | list) and inside and data.draw(st.booleans()):
            where = inside
            continue
        strange: st.SearchStrategy[Any] = st.one_of(
            st.integers(-1, 2**33), st.none(), st.text(max_size=3), st.floats(0, 9)
        )
        where[key] = data.draw(strange)
        break
    try:
        pieces = read_glb(put_together(document, binary))
    except ValueError:
        return
    assert all(np.isfinite(piece.points).all() for piece in pieces)


@given(st.integers(0, len(PLAIN) - 1), st.integers(0, 255))
def test_whatever_byte_is_flipped_is_read_or_refused(place: int, value: int) -> None:
    data = bytearray(PLAIN)
    data[place] = value
    with contextlib.suppress(ValueError):
        assert all(np.isfinite(piece.points).all() for piece in read_glb(bytes(data)))
