"""What is packed comes back exactly, and nothing else is taken for a content."""

import contextlib
import zlib
from collections.abc import Callable
from dataclasses import fields, replace

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from omote.interchange.formats.png import png_bytes, read_png
from omote.model.albedo import Albedo
from omote.model.body.pose_recipe import Arm, Leg, PoseRecipe
from omote.model.cast import TRAITS, Cast, Look
from omote.model.space.complexion import PALE
from omote.model.space.expression import Expression
from omote.model.space.face import Face
from omote.model.space.gain import GAIN_REGIONS, Gain
from omote.showfile import contents
from omote.showfile.changes import Kind, content_key
from omote.showfile.contents import (
    ContentError,
    content_kind,
    pack_expression,
    pack_face,
    pack_pose,
    read_albedo,
    unpack_expression,
    unpack_face,
    unpack_pose,
)

numbers = st.one_of(st.just(0.0), st.just(0.0), st.just(-0.0), st.floats(-1e6, 1e6))
ratios = st.one_of(st.just(1.0), st.just(1.0), st.floats(1e-9, 1e6))
names = st.text(st.characters(codec="utf-8"), max_size=12)
colours = st.from_regex(r"#[0-9a-f]{6}", fullmatch=True)
looks = st.builds(
    Look,
    **{name: st.floats(low, high) for name, (low, high) in TRAITS.items()},
    **dict.fromkeys(("skin", "lip", "brow", "blush", "iris", "hair", "coat"), colours),
    hair_style=st.sampled_from(["", "bob"]),
)


@st.composite
def expressions(draw: st.DrawFn) -> Expression:
    """Any expression, most of it at rest or not."""
    count = draw(st.integers(0, 40))
    inner = draw(st.integers(0, 10))
    parts = {name: draw(arrays(np.float64, (draw(st.integers(0, 9)), 3), elements=numbers)) for name in draw(
        st.lists(names, max_size=3, unique=True)
    )}  # fmt: skip
    return Expression(
        dtheta=draw(arrays(np.float64, count, elements=numbers)),
        dh=draw(arrays(np.float64, count, elements=numbers)),
        ratio=draw(arrays(np.float64, count, elements=ratios)),
        residual=draw(arrays(np.float64, (inner, 3), elements=numbers)),
        parts=parts,
        eyes=draw(arrays(np.float64, (2, 2), elements=numbers)),
        radius=draw(st.sampled_from(["origin", "other"])),
        transfer=draw(st.sampled_from(["smooth", "paper"])),
        pupil=draw(numbers),
        ears=draw(arrays(np.float64, (2, 3), elements=numbers)),
        head=draw(arrays(np.float64, 3, elements=numbers)),
        complexion=draw(st.one_of(st.just(PALE), st.tuples(*[st.floats(-2.0, 2.0)] * len(PALE)))),
    )


@st.composite
def faces(draw: st.DrawFn) -> Face:
    """Any face."""
    single = st.floats(-1e6, 1e6, width=32)
    shape = st.integers(1, 30).map(lambda count: (count, 3))
    parts = {name: draw(arrays(np.float32, shape, elements=single)) for name in draw(st.lists(names, max_size=2))}
    gains = st.builds(Gain, st.sampled_from(GAIN_REGIONS), st.floats(0.0, 4.0), st.sampled_from([None, "joy"]))
    own = draw(st.lists(gains, max_size=4, unique_by=lambda gain: (gain.region, gain.expression)))
    return Face("any", draw(arrays(np.float32, shape, elements=single)), parts, tuple(own))


def bits(expression: Expression) -> list[object]:
    """Everything of an expression, to the bit, parts in order of their names."""
    own = [getattr(expression, name) for name in ("dtheta", "dh", "ratio", "residual", "eyes", "ears", "head")]
    parts = sorted(expression.parts.items())
    numbers = [(array.shape, array.tobytes()) for array in (*own, np.array(expression.pupil), *(p for _, p in parts))]
    return [*numbers, expression.complexion, [name for name, _ in parts], expression.radius, expression.transfer]


@given(expressions())
def test_an_expression_comes_back_to_the_bit(expression: Expression) -> None:
    data = pack_expression(expression)
    again = unpack_expression(data)
    assert bits(again) == bits(expression)
    assert pack_expression(again) == data
    assert content_kind(data) == "expression"


@given(faces(), looks)
def test_a_face_comes_back_to_the_bit(face: Face, look: Look) -> None:
    data = pack_face(face, look)
    again, its_look = unpack_face(data, "new name")
    assert again.name == "new name"
    assert its_look == look
    assert again.gains == face.gains
    assert again.positions.tobytes() == face.positions.tobytes()
    assert {name: part.tobytes() for name, part in again.parts.items()} == {
        name: part.tobytes() for name, part in face.parts.items()
    }
    assert pack_face(again, look) == data
    assert content_kind(data) == "face"


def test_a_picture_of_skin_comes_back_and_changes_no_content_without_one() -> None:
    face = Face("a", np.eye(3))
    texels = np.random.default_rng(5).integers(0, 256, (1024, 1024, 4), np.uint8)
    look = replace(Look(), albedo=Albedo(texels))
    data = pack_face(face, look)
    assert unpack_face(data, "a")[1] == look
    assert pack_face(face, unpack_face(data, "a")[1]) == data
    picture = read_albedo(data)
    assert picture is not None
    np.testing.assert_array_equal(read_png(picture), texels)
    assert read_albedo(pack_face(face, Look())) is None
    assert "albedo" not in plain(pack_face(face, Look()))


@pytest.mark.parametrize("picture", [b"", b"GIF89a", png_bytes(np.zeros((8, 8, 4), np.uint8))])
def test_what_is_no_picture_of_skin_is_refused(picture: bytes) -> None:
    with pytest.raises(ContentError, match="holds no face"):
        unpack_face(packed(plain(pack_face(Face("a", np.eye(3)), Look())) | {"albedo": picture}), "a")


def test_the_synthetic_cast_comes_back(cast: Cast) -> None:
    for expression in cast.expressions.values():
        assert bits(unpack_expression(pack_expression(expression))) == bits(expression)
    again = cast
    for name, face in cast.faces.items():
        copy, look = unpack_face(pack_face(face, cast.looks[name]), name)
        again = again.with_faces(copy, looks={name: look})
    assert again.digest == cast.digest


def test_the_order_of_parts_does_not_count() -> None:
    rest = np.zeros(3)
    a, b = np.zeros((1, 3)), np.ones((2, 3))
    one = Expression(rest, rest, np.ones(3), np.zeros((0, 3)), parts={"a": a, "b": b})
    other = Expression(rest, rest, np.ones(3), np.zeros((0, 3)), parts={"b": b, "a": a})
    assert pack_expression(one) == pack_expression(other)


def test_what_rests_takes_no_room() -> None:
    count = 10_000
    field = np.zeros(count)
    small = len(pack_expression(Expression(field, field, np.ones(count), np.zeros((0, 3)))))
    field = np.random.default_rng(1).normal(size=count)
    large = len(pack_expression(Expression(field, field, np.ones(count), np.zeros((0, 3)))))
    assert small < 300 < 100_000 < large


def test_keys_are_24_hexadecimal_digits_and_tell_bytes_apart() -> None:
    assert len(content_key(b"")) == 24
    assert int(content_key(b""), 16)
    assert content_key(b"a") != content_key(b"b")
    assert content_key(b"a") == content_key(b"a")


def simple() -> Expression:
    """Five vertices, one of which moves."""
    return Expression(np.eye(5)[2], np.zeros(5), np.ones(5), np.zeros((1, 3)), parts={"tongue": np.ones((2, 3))})


def plain(data: bytes) -> dict[str, object]:
    """The map inside a content."""
    found: dict[str, object] = msgspec.msgpack.decode(zlib.decompress(data[5:]))
    return found


def packed(document: object) -> bytes:
    """Any document as if it were a content."""
    return b"OMOC\x01" + zlib.compress(msgspec.msgpack.encode(document))


def test_one_kind_is_not_taken_for_the_other() -> None:
    packed: dict[Kind, bytes] = {
        "face": pack_face(Face("a", np.zeros((3, 3))), Look()),
        "expression": pack_expression(simple()),
        "pose": pack_pose(PoseRecipe(hips=(0.0, -0.5, 0.0))),
    }
    unpack: dict[Kind, Callable[[bytes], object]] = {
        "face": lambda data: unpack_face(data, "a"),
        "expression": unpack_expression,
        "pose": unpack_pose,
    }
    for kind, data in packed.items():
        assert content_kind(data) == kind
        for other in unpack.keys() - {kind}:
            with pytest.raises(ContentError, match=f"of another kind: {kind}; expected an? {other}"):
                unpack[other](data)


@given(st.floats(-200.0, 200.0), st.floats(-1.0, 1.5), st.floats(-3.0, 3.0))
def test_a_pose_comes_back_exactly_and_as_the_same_bytes(degrees: float, curl: float, legs: float) -> None:
    arm = Arm(raised=degrees, wrist=(0.0, degrees), curls=(0.0, curl, 0.0, 0.0, 1.0))
    recipe = PoseRecipe(hips=(0.0, legs, 0.0), head=(degrees, 0.0, 0.0), left=arm, right_leg=Leg(at=(legs, 0.0, 0.0)))
    assert unpack_pose(pack_pose(recipe)) == recipe
    assert pack_pose(unpack_pose(pack_pose(recipe))) == pack_pose(recipe)


@given(st.data())
def test_cut_and_changed_bytes_are_refused_or_read_never_more(data: st.DataObject) -> None:
    whole = bytearray(data.draw(st.sampled_from([pack_expression(simple()), pack_face(Face("a", np.eye(3)), Look())])))
    for place in data.draw(st.lists(st.integers(0, len(whole) - 1), max_size=3)):
        whole[place] ^= data.draw(st.integers(1, 255))
    torn = bytes(whole[: data.draw(st.integers(0, len(whole)))])
    for unpack in (unpack_expression, lambda torn: unpack_face(torn, "a"), content_kind):
        with contextlib.suppress(ContentError):
            unpack(torn)


def test_every_cut_is_refused() -> None:
    whole = pack_expression(simple())
    for length in range(len(whole)):
        with pytest.raises(ContentError):
            unpack_expression(whole[:length])
    with pytest.raises(ContentError, match="goes on after its end"):
        unpack_expression(whole + b"\0")


documents = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(-(2**63), 2**64 - 1), st.floats(), st.binary(max_size=40), names),
    lambda inner: st.one_of(st.lists(inner, max_size=4), st.dictionaries(names, inner, max_size=4)),
    max_leaves=8,
)
hostile_arrays = st.one_of(
    documents,
    st.tuples(
        st.lists(st.one_of(st.integers(-5, 10), st.integers(0, 2**40)), max_size=3),
        st.one_of(st.none(), st.binary(max_size=16)),
        st.binary(max_size=48),
    ),
)


@given(st.data())
def test_hostile_documents_are_refused_with_a_sentence(data: st.DataObject) -> None:
    document = plain(pack_expression(simple()))
    for field in data.draw(st.lists(st.sampled_from(sorted(document)), min_size=1, max_size=3)):
        document[field] = data.draw(hostile_arrays)
    face = plain(pack_face(Face("a", np.eye(3)), Look())) | {"positions": data.draw(hostile_arrays)}
    face["look"] = data.draw(st.dictionaries(st.sampled_from([f.name for f in fields(Look)]) | names, documents))
    for unpack in (lambda: unpack_expression(packed(document)), lambda: unpack_face(packed(face), "a")):
        with contextlib.suppress(ContentError):
            unpack()


def test_a_bomb_is_refused_before_it_is_unpacked() -> None:
    bomb = b"OMOC\x01" + zlib.compress(bytes(contents.MOST_BYTES + 1))
    with pytest.raises(ContentError, match="unpacks to more than"):
        unpack_expression(bomb)


@pytest.mark.parametrize(
    ("shape", "sentence"),
    [
        ([2**40], "expected rows of numbers"),
        ([-1], "expected rows of numbers"),
        ([1, 1, 1], "expected rows of numbers"),
        ([contents.MOST_NUMBERS], "numbers; expected at most"),
    ],
)
def test_rows_at_rest_are_counted_before_they_are_made(shape: list[int], sentence: str) -> None:
    document = plain(pack_expression(simple())) | {"dh": [shape, b"", b""]}
    with pytest.raises(ContentError, match=sentence):
        unpack_expression(packed(document))


@pytest.mark.parametrize(
    ("array", "sentence"),
    [
        ([[5], b"\0", b""], "expected four for each"),
        ([[5], b"\5\0\0\0", bytes(8)], "not rows 0 to 4"),
        ([[5], b"\1\0\0\0\1\0\0\0", bytes(16)], "each once and rising"),
        ([[5], b"\1\0\0\0", bytes(7)], "7 bytes for 1 rows"),
        ([[5], None, bytes(8)], "8 bytes for 5 rows"),
        ([[], None, bytes(8)], "no expression|bytes|rows"),
        ([[4], b"", b""], "shape"),
        ([[5], None, np.full(5, np.nan).tobytes()], "finite"),
    ],
)
def test_wrong_arrays_are_refused(array: object, sentence: str) -> None:
    document = plain(pack_expression(simple())) | {"dh": array}
    with pytest.raises(ContentError, match=sentence):
        unpack_expression(packed(document))


def test_a_newer_version_and_a_newer_look_say_update() -> None:
    data = bytearray(pack_expression(simple()))
    data[4] = 2
    with pytest.raises(ContentError, match="version 2; this Omote reads version 1: update"):
        unpack_expression(bytes(data))
    document = plain(pack_face(Face("a", np.eye(3)), Look()))
    with pytest.raises(ContentError, match="'horns', which this Omote does not know: update"):
        unpack_face(packed(document | {"look": {"horns": 1.0}}), "a")
    with pytest.raises(ContentError, match="hair_style"):
        unpack_face(packed(document | {"look": {"hair_style": 1.0}}), "a")
    with pytest.raises(ContentError, match="no face: pores of a look is 2"):
        unpack_face(packed(document | {"look": {"pores": 2.0}}), "a")


def test_a_look_of_before_a_trait_takes_its_usual_value() -> None:
    document = plain(pack_face(Face("a", np.eye(3)), replace(Look(), pores=0.1)))
    face, look = unpack_face(packed(document | {"look": {"pores": 0.1}}), "a")
    assert look == replace(Look(), pores=0.1)
    assert len(face.positions) == 3


def test_what_moves_no_ears_and_what_has_no_gains_is_packed_as_before_there_were_any() -> None:
    assert not {"ears", "head"} & plain(pack_expression(simple())).keys()
    document = plain(pack_face(Face("a", np.eye(3)), Look()))
    assert "gains" not in document
    with pytest.raises(ContentError, match="no face: a gain is of region 'tail'"):
        unpack_face(packed(document | {"gains": [["tail", 1.0, None]]}), "a")
    with pytest.raises(ContentError, match="no face: the gain of mouth is 9"):
        unpack_face(packed(document | {"gains": [["mouth", 9.0, None]]}), "a")


def test_a_content_that_could_not_be_read_again_is_not_packed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(contents, "MOST_BYTES", 100)
    with pytest.raises(ContentError, match="expected at most 100"):
        pack_expression(simple())
