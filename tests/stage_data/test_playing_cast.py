"""The cast that plays: own things beside the built-in cast, named by what they are."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest

from omote.inputs.osc_orders import OrderReader
from omote.inputs.osc_packet import OscMessage
from omote.model.cast import Cast, Look
from omote.model.space.expression import Expression, Title
from omote.model.space.face import Face
from omote.perform.called_names import find_called
from omote.perform.layers.columns import columns_of
from omote.perform.layers.layer_names import LAYER_PARTS, WHOLE
from omote.show.cast_documents import Manifest
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.calls import CallExpression, CallFace
from omote.show.objects.link import Hello
from omote.show.session import ShowSession
from omote.showfile.changes import content_key
from omote.showfile.contents import ContentError, pack_expression, pack_face
from omote.stage_data.assets import content_asset, documents
from omote.stage_data.playing_cast import Own, PlayingCast, build_playing_cast, digest_of, manifest_of
from tests.server.synthetic_server import meshes

Contents = dict[str, bytes]


def kept(contents: Contents, data: bytes) -> str:
    """The key of a content, which is among the contents from now on."""
    contents[content_key(data)] = data
    return content_key(data)


def grin(cast: Cast, contents: Contents, *, place: float = 1.0, name: str = "grin") -> Own:
    """The cast's smile as an own expression."""
    key = kept(contents, pack_expression(cast.expressions["smile"]))
    return Own("expression", name, "Grin", ("happy",), place, key)


def cousin(cast: Cast, contents: Contents) -> tuple[Own, Face]:
    """An own face between two of the cast."""
    mixed = (cast.faces["broad"].positions + cast.faces["long"].positions) / 2
    face = Face("cousin", mixed)
    return Own("face", "cousin", "Cousin", (), 2.0, kept(contents, pack_face(face, Look(skin="#102030")))), face


def test_own_things_stand_behind_the_built_in_cast(cast: Cast) -> None:
    contents: Contents = {}
    own = (grin(cast, contents), cousin(cast, contents)[0])
    playing = build_playing_cast(cast, own, contents)
    assert [*playing.expressions] == [*cast.expressions, "grin"]
    assert [*playing.faces] == [*cast.faces, "cousin"]
    assert playing.faces["cousin"] == own[1].source == "#" + own[1].content
    assert playing.expression_sources["grin"] == own[0].source
    assert all(playing.expression_sources[name] == name for name in cast.expressions)
    assert np.array_equal(playing.expressions["grin"].dh, cast.expressions["smile"].dh)


def test_own_things_are_called_by_their_labels_too_over_osc_and_by_programs(cast: Cast) -> None:
    contents: Contents = {}
    own = grin(cast, contents, name="on_air_1"), msgspec.structs.replace(cousin(cast, contents)[0], label="My Cousin")
    playing = build_playing_cast(cast, own, contents)
    assert find_called("GRIN", "expression", playing) == find_called("Grin", "channel", playing) == "on_air_1"
    assert find_called("my-cousin", "face", playing) == "cousin"
    assert find_called("smile", "expression", playing) == "smile"
    calls = OscMessage("/omote/one/expression", ("Grin",)), OscMessage("/omote/one/face", ("My Cousin",))
    reader = OrderReader(playing, {"one": "One"})
    session = ShowSession(playing)
    session.receive("a", Hello("console", PROTOCOL_VERSION, "Ana"), 0.0)
    for call, message in zip(
        calls,
        (CallExpression("one", "1", "Grin", 0.0, "smooth"), CallFace("one", "2", "My Cousin", 0.0, "smooth")),
        strict=True,
    ):
        (order,) = reader.read(call, "o")
        assert getattr(order, "name", "") in ("on_air_1", "cousin")
        assert session.receive("a", message, 0.0) == []
    state = session.tick(0.0).characters["one"]
    assert (state.expressions, state.faces) == ({"on_air_1": 1.0}, {"cousin": 1.0})


def test_layers_take_each_channel_for_the_part_of_the_face_where_it_acts(cast: Cast) -> None:
    contents: Contents = {}
    named = replace(cast, titles={"smile": Title("Smile", region="mouth")})
    playing = build_playing_cast(named, (grin(cast, contents),), contents)
    assert columns_of(named, ("smile",)).parts[0] == LAYER_PARTS.index("mouth")
    names = tuple(named.expressions)
    assert columns_of(playing, names).parts.tolist() == columns_of(named, names).parts.tolist()
    assert columns_of(playing, ("grin",)).parts[0] == WHOLE


def test_the_digest_names_exactly_this_cast(cast: Cast) -> None:
    contents: Contents = {}
    first = grin(cast, contents)
    later = grin(cast, contents, place=2.0)
    face, _ = cousin(cast, contents)
    assert build_playing_cast(cast, (), {}).digest == cast.digest
    found = {build_playing_cast(cast, own, contents).digest for own in ((first,), (later,), (first, face), ())}
    assert len(found) == 4
    assert build_playing_cast(cast, (first,), contents).digest == digest_of(cast.digest, (first,))


def test_what_was_unpacked_is_not_unpacked_again(cast: Cast) -> None:
    contents: Contents = {}
    own = grin(cast, contents)
    before = build_playing_cast(cast, (own,), contents)
    renamed = msgspec.structs.replace(own, label="Smirk")
    after = build_playing_cast(cast, (renamed,), {}, before=before)  # without its bytes
    assert after.expressions["grin"] is before.expressions["grin"]
    with pytest.raises(KeyError):
        build_playing_cast(cast, (own,), {})


def test_a_name_of_the_cast_is_not_given_twice(cast: Cast) -> None:
    contents: Contents = {}
    for own in ((grin(cast, contents, name="smile"),), (grin(cast, contents), grin(cast, contents))):
        with pytest.raises(ValueError, match=r"there are two expressions named '(smile|grin)'"):
            build_playing_cast(cast, own, contents)
    both = (grin(cast, contents, name="cousin"), cousin(cast, contents)[0])
    assert build_playing_cast(cast, both, contents).own == both  # a face and an expression may share one


def test_an_expression_of_another_head_is_refused(cast: Cast) -> None:
    small = Expression(np.zeros(9), np.zeros(9), np.ones(9), np.zeros((0, 3)))
    contents: Contents = {}
    own = Own("expression", "small", "Small", (), 1.0, kept(contents, pack_expression(small)))
    with pytest.raises(ValueError, match="has 9 vertices; expected the"):
        build_playing_cast(cast, (own,), contents)
    face = Own("expression", "face", "Face", (), 1.0, cousin(cast, contents)[0].content)
    with pytest.raises(ContentError):
        build_playing_cast(cast, (face,), contents)


def test_a_face_of_another_head_is_refused(cast: Cast) -> None:
    contents: Contents = {}
    cut = Face("cut", cast.faces["long"].positions[1:])
    own = Own("face", "cut", "Cut", (), 1.0, kept(contents, pack_face(cut, Look())))
    count = cast.space.vertex_count
    with pytest.raises(ValueError, match=f"the face has {count - 1} vertices; expected the {count} of this cast"):
        build_playing_cast(cast, (own,), contents)


def test_nothing_is_unpacked_before_somebody_wants_it_and_what_is_none_plays_as_nothing(cast: Cast) -> None:
    contents: Contents = {}
    own = (grin(cast, contents), Own("expression", "lost", "Lost", (), 2.0, "0" * 24))
    playing = build_playing_cast(cast, own, contents, check=False)
    assert [*playing.expressions] == [*cast.expressions, "grin", "lost"]
    assert len(playing.expressions) == len(cast.expressions) + 2
    assert "grin" in playing.expressions
    assert "nothing" not in playing.expressions
    grins = playing.expressions["grin"]
    assert np.array_equal(grins.dh, cast.expressions["smile"].dh)
    assert playing.expressions["grin"] is grins
    assert playing.expressions["lost"] is cast.expressions["neutral"]
    with pytest.raises(KeyError):
        playing.expressions["nothing"]


def manifest(cast: Cast, playing: PlayingCast, contents: Contents) -> Manifest:
    """The manifest of a playing cast with all its faces."""
    built_in = documents(cast, meshes(cast), mask="/mask").manifest
    faces = {}
    for own in playing.own:
        if own.kind == "face":
            _, face = cousin(cast, contents)
            faces[own.content] = content_asset(cast, own.content, face, Look(skin="#102030")).face
    return manifest_of(playing, built_in, faces)


def test_the_manifest_tells_people_what_they_call_it_and_pages_where_it_is(cast: Cast) -> None:
    contents: Contents = {}
    own = (grin(cast, contents), cousin(cast, contents)[0])
    playing = build_playing_cast(cast, own, contents)
    found = manifest(cast, playing, contents)
    assert (found.base, found.digest) == (cast.digest, playing.digest)
    expression = found.expressions[-1]
    face = found.faces[-1]
    assert (expression.name, expression.label, expression.kind, expression.tags) == ("grin", "Grin", "own", ["happy"])
    assert (face.name, face.label, face.source, face.place) == ("cousin", "Cousin", own[1].source, 2.0)
    assert (face.url, face.look.skin) == (f"/contents/{own[1].content}", "#102030")
    assert [each.source for each in found.faces[:-1]] == [*cast.faces]
    assert manifest(cast, build_playing_cast(cast, (), {}), {}) == documents(cast, meshes(cast), mask="/mask").manifest


def test_a_face_that_could_not_be_made_is_left_out_of_the_manifest(cast: Cast) -> None:
    contents: Contents = {}
    playing = build_playing_cast(cast, (cousin(cast, contents)[0],), contents)
    found = manifest_of(playing, documents(cast, meshes(cast), mask="/mask").manifest, {})
    assert [face.name for face in found.faces] == [*cast.faces]
