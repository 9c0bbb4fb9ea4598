"""Faces as scenes: what others read is where our compounds are, on every mesh, for every expression."""

from pathlib import Path

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.geometry import mesh
from omote.interchange.export_face import REST, ExportContext, build_scene, choose_expressions, named_compound_meshes
from omote.interchange.formats.glb_reader import read_glb
from omote.interchange.formats.glb_writer import glb_bytes
from omote.model.cast import Cast
from omote.model.space.face_fit import fit
from omote.model.space.parts import eye_rotation
from omote.model.transfer.compound import compound
from tests import synthetic
from tests.stage_data.heads import context, synthetic_cast
from tools.gltf import inspect

ARKIT = 52


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast; skipped where it was not baked."""
    return load_cast()


def test_expressions_are_named_by_kind_or_by_name() -> None:
    cast = synthetic_cast()
    assert choose_expressions(cast, "performed") == ["smile"]
    others = [name for name in synthetic.EXPRESSIONS if name not in ("neutral", "smile")]
    assert choose_expressions(cast, "smile, arkit,smile") == ["smile", *others]
    assert sorted(choose_expressions(cast, "all")) == sorted(set(synthetic.EXPRESSIONS) - {"neutral"})
    assert choose_expressions(cast, "jaw open, SMILE") == ["jawOpen", "smile"]
    assert choose_expressions(cast, "neutral") == []
    assert choose_expressions(cast, "Performed,AU26") == ["smile", "jawOpen"]
    with pytest.raises(ValueError, match=r"there are no own expressions here; name a show file"):
        choose_expressions(cast, "own")
    with pytest.raises(ValueError, match="' , ' names no expression; give names or a kind"):
        choose_expressions(cast, " , ")
    with pytest.raises(
        ValueError, match=r"no expression 'grin' in this cast; near are .*; or name a kind: neutral, arkit"
    ):
        choose_expressions(cast, "smile,grin")


def test_a_face_that_is_not_there_is_refused() -> None:
    with pytest.raises(ValueError, match="there is no face 'nobody' in this cast"):
        named_compound_meshes(synthetic_cast(), "nobody", "smile")
    with pytest.raises(ValueError, match="there is no face 'nobody' in this cast"):
        build_scene(context(), "nobody", [])


@pytest.mark.parametrize("face", synthetic.FACES)
def test_what_is_read_is_where_the_compounds_are(face: str) -> None:
    cast = synthetic_cast()
    names = choose_expressions(synthetic_cast(), "all")
    worn = {name: named_compound_meshes(cast, face, name) for name in names}
    pieces = read_glb(glb_bytes(build_scene(context(), face, worn.items())))
    assert [piece.name for piece in pieces] == ["skin", *cast.space.parts]
    for piece in pieces:
        assert list(piece.moves) == names
        for name in names:
            aim = worn[name][piece.name][piece.rows]
            np.testing.assert_allclose(piece.points + piece.moves[name], aim, atol=2 * REST)


def test_eyeballs_turn_about_the_centres_that_their_nodes_stand_at() -> None:
    cast = synthetic_cast()
    side, yaw, pitch = synthetic.LOOKS["eyeLookOutLeft"]
    scene = build_scene(context(), "generic", [("out", named_compound_meshes(cast, "generic", "eyeLookOutLeft"))])
    ball = next(shape for shape in scene.shapes if shape.name == f"eye_{side}")
    np.testing.assert_allclose(ball.points.mean(axis=0), 0.0, atol=1e-7)
    turned = ball.points @ eye_rotation(yaw, pitch).T
    np.testing.assert_allclose(ball.points + ball.targets["out"].moves, turned, atol=1e-6)
    np.testing.assert_allclose(ball.place, fit(cast.space, cast.faces["generic"]).centres[ball.name], atol=1e-7)


def test_no_seam_shows_in_the_light() -> None:
    cast = synthetic_cast()
    scene = build_scene(context(), "broad", [("smile", named_compound_meshes(cast, "broad", "smile"))])
    skin = scene.shapes[0]
    assert skin.rows is not None
    for values in (skin.points, skin.normals, skin.targets["smile"].moves, skin.targets["smile"].turns):
        np.testing.assert_array_equal(values[-1], values[0])
    worn = compound(cast.space, cast.faces["broad"], cast.expressions["smile"]).astype(np.float64)
    upright = mesh.normals(worn, cast.space.welded[cast.space.triangles])[skin.rows]
    np.testing.assert_allclose(skin.normals + skin.targets["smile"].turns, upright, atol=2e-4)


@pytest.mark.parametrize(("face", "drawn"), [("kaori", False), ("dog", True)])
def test_khronos_and_three_take_the_built_in_faces(face: str, drawn: bool, built_in: Cast, tmp_path: Path) -> None:
    names = choose_expressions(built_in, "arkit")
    whole = ExportContext(built_in, load_meshes(), load_mask())
    path = tmp_path / "face.glb"
    path.write_bytes(
        glb_bytes(build_scene(whole, face, ((n, named_compound_meshes(built_in, face, n)) for n in names), drawn=drawn))
    )
    (found,) = inspect([path])
    assert found["validator"]["said"] == []
    assert found["three"]["root"] == [face]
    hair = {"hair"} if built_in.looks[face].hair_style else set()
    collar = {"collar"} if drawn else set()
    assert found["three"]["meshes"].keys() == {"skin", *built_in.space.parts} | hair | collar
    assert len(names) == ARKIT
    for each in found["three"]["meshes"].values():
        assert each["targets"] == {name: place for place, name in enumerate(names)}
