"""The documents say where every vertex is, to well below what anybody sees."""

import dataclasses
import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from omote.builtin import BakedMesh, load_cast
from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.model.space.gain import Gain
from omote.model.transfer.compound import compound, compound_parts
from omote.perform.blending.evaluate import evaluate, evaluate_parts
from omote.perform.frame import Frame
from omote.perform.lights import LIGHTS
from omote.show.cast_documents import Manifest
from omote.show.wire import encode
from omote.stage_data.assets import (
    FINEST_STEP,
    compound_asset,
    content_name,
    documents,
    extremes,
    first_rows,
    outline,
    quantise,
    rest_positions,
    unit_tags,
)
from tests import synthetic
from tests.compound_assets import unpack_compound
from tests.server.synthetic_server import meshes

STAGE_LIMIT = 0.05e-3
"""Metres that the stage may be off the evaluator."""


def written(cast: Cast) -> Manifest:
    """The manifest of a cast drawn without seams."""
    return documents(cast, meshes(cast), mask="/assets/mask").manifest


def test_lines_and_pupils_are_those_of_the_cast(cast: Cast) -> None:
    wide = dataclasses.replace(cast.expressions["smile"], pupil=0.25)
    manifest = written(cast.with_expressions(smile=wide))
    pupils = {expression.name: expression.pupil for expression in manifest.expressions}
    assert pupils == {**dict.fromkeys(cast.expressions, 0.0), "smile": 0.25}
    lines = {line.name: np.frombuffer(line.loop, "<u4").tolist() for line in manifest.lines}
    assert lines == {line.name: line.loop.tolist() for line in cast.space.lines}


@given(moves=hnp.arrays(np.float64, st.tuples(st.integers(0, 50), st.just(3)), elements=st.floats(-0.05, 0.05)))
def test_quantised_moves_come_back_within_half_a_count(moves: np.ndarray) -> None:
    asset = quantise(moves)
    assert np.abs(unpack_compound(asset, len(moves)) - moves).max(initial=0.0) <= 0.5000001 * asset.scale
    assert FINEST_STEP <= asset.scale <= max(0.05 / 32767, FINEST_STEP)


@given(count=st.integers(1, 30), step=st.floats(0.0, FINEST_STEP * 0.49))
def test_what_moves_less_than_anybody_sees_is_not_sent(count: int, step: float) -> None:
    assert quantise(np.full((count, 3), step)).indices == b""


@pytest.mark.parametrize(("face", "expression"), [*itertools.product(synthetic.FACES, synthetic.EXPRESSIONS)])
def test_face_and_compound_together_are_the_compound_of_the_model(cast: Cast, face: str, expression: str) -> None:
    worn = cast.faces[face]
    rest = rest_positions(cast, cast.faces[face])
    shown = rest + unpack_compound(compound_asset(cast, worn, expression), len(rest))
    field = cast.expressions[expression]
    parts = compound_parts(cast.space, worn, field)
    expected = np.concatenate([compound(cast.space, worn, field), *(parts[name] for name in cast.space.parts)])
    assert np.abs(shown - expected).max() < FINEST_STEP


def test_what_a_stage_blends_is_what_the_evaluator_gives(cast: Cast) -> None:
    frame = Frame(
        faces={"generic": 0.3, "broad": 0.7},
        expressions={"neutral": 0.2, "smile": 0.5, "jawOpen": 0.3},
        channels={"browInnerUp": 1.2, "jawOpen": -0.3},
    )
    parts = evaluate_parts(cast, frame)
    still = [name for name, part in cast.space.parts.items() if not part.eye]
    expected = {"skin": evaluate(cast, frame), **{name: parts[name] for name in still}}
    shown = blended(cast, frame)
    rows = first_rows(cast)
    for name, points in expected.items():
        assert np.abs(shown[rows[name] : rows[name] + len(points)] - points).max() < STAGE_LIMIT / 10


def blended(cast: Cast, frame: Frame) -> np.ndarray:
    """What a stage makes of a frame from the documents alone."""
    shown = np.zeros_like(rest_positions(cast, cast.faces["generic"]), np.float64)
    for name, share in frame.faces.items():
        face = cast.faces[name]
        moves = {
            e: unpack_compound(compound_asset(cast, face, e), len(shown)) for e in {*frame.expressions, *frame.channels}
        }
        weights = [*frame.expressions.items(), *frame.channels.items()]
        shown += share * (rest_positions(cast, face) + sum(weight * moves[name] for name, weight in weights))
    return shown


def test_the_manifest_lists_the_lights(cast: Cast) -> None:
    assert {light.name: light.label for light in written(cast).lights} == {
        name: light.label for name, light in LIGHTS.items()
    }


def test_the_manifest_counts_what_there_is(cast: Cast) -> None:
    manifest = written(cast)
    assert manifest.digest == cast.digest
    assert manifest.skin == cast.space.vertex_count
    assert manifest.vertices == len(rest_positions(cast, cast.faces["generic"]))
    assert [face.name for face in manifest.faces] == list(cast.faces)
    assert [expression.name for expression in manifest.expressions] == list(cast.expressions)
    assert encode(manifest) == encode(written(cast))


def test_the_manifest_says_how_a_face_answers_and_how_heads_turn(cast: Cast) -> None:
    loud = dataclasses.replace(cast.faces["long"], gains=(Gain("brows", 2.0), Gain("head", 1.0, "smile")))
    nod = dataclasses.replace(cast.expressions["smile"], head=np.array([0.0, 0.1, -0.2]))
    manifest = written(cast.with_faces(loud).with_expressions(smile=nod))
    gains = {face.name: [(row.region, row.value, row.expression) for row in face.gains] for face in manifest.faces}
    assert gains == {"generic": [], "broad": [], "long": [("brows", 2.0, None), ("head", 1.0, "smile")]}
    heads = {expression.name: expression.head for expression in manifest.expressions}
    assert heads == {**dict.fromkeys(cast.expressions, (0.0, 0.0, 0.0)), "smile": (0.0, 0.1, -0.2)}


def test_meshes_draw_their_own_rows(cast: Cast) -> None:
    manifest = written(cast)
    rows = first_rows(cast)
    assert list(rows.values()) == sorted(rows.values())
    for mesh in manifest.meshes:
        source = np.frombuffer(mesh.source, "<u4")
        assert source.min() == rows[mesh.name]
        assert source.max() < manifest.vertices
        assert np.frombuffer(mesh.triangles, "<u4").max() < len(source)
        assert len(np.frombuffer(mesh.uv, "<f4")) == 2 * len(source)


def test_a_face_asset_is_the_face_and_named_by_its_content(cast: Cast) -> None:
    packed = documents(cast, [], mask="")
    for face in packed.manifest.faces:
        positions = packed.faces[face.url].positions
        assert positions == rest_positions(cast, cast.faces[face.name]).astype("<f4").tobytes()
        assert face.url == f"/assets/{content_name(positions)}"
        assert face.eye_radius == pytest.approx(0.012, rel=0.3)
        assert face.centres[0][0] > 0 > face.centres[1][0]


def test_a_mesh_of_no_part_is_refused(cast: Cast) -> None:
    nothing = np.zeros((1, 3), np.int32)
    stray = BakedMesh("hat", nothing[:, 0], np.zeros((1, 2), np.float32), nothing, np.zeros(1, np.uint8))
    with pytest.raises(ValueError, match="there is no part 'hat' to draw; the space has skin, "):
        documents(cast, [stray], mask="")


def test_a_kind_that_no_palette_has_is_refused(cast: Cast) -> None:
    odd = dataclasses.replace(cast, titles={"smile": Title("Smile", kind="odd")})
    with pytest.raises(ValueError, match="odd"):
        documents(odd, [], mask="")


def test_a_face_says_what_a_picture_has_to_hold(cast: Cast) -> None:
    for face in cast.faces.values():
        found = extremes(face.positions)
        assert found.shape == (6, 3)
        assert [found[2 * axis][axis] for axis in range(3)] == face.positions.min(axis=0).tolist()
        assert [found[2 * axis + 1][axis] for axis in range(3)] == face.positions.max(axis=0).tolist()


def test_the_picture_of_an_animal_holds_its_ears_however_expressions_turn_them() -> None:
    cast = load_cast()
    for name in ("dog", "cat"):
        face = cast.faces[name]
        ends = extremes(outline(cast, face, cast.looks[name].hair_style))
        for expression in ("joy", "laugh", "surprise", "sad"):
            worn = compound(cast.space, face, cast.expressions[expression])
            assert worn[:, 0].max() <= ends[1][0] + 0.003, (name, expression)
            assert worn[:, 0].min() >= ends[0][0] - 0.003, (name, expression)


def test_palettes_find_a_channel_by_its_action_units() -> None:
    assert unit_tags("mouthSmileLeft") == ["AU12L", "Lip corner puller"]
    assert unit_tags("eyebrows-left-up") == ["AU1L", "Inner brow raiser", "AU2L", "Outer brow raiser"]
    assert unit_tags("jawOpen") == ["AU26", "Jaw drop"]
    assert unit_tags("joy") == []
