"""What files bring: each kind by its own reader, parsed in a process of its own, with a sentence about each thing.

Heads of any topology bring their shapes, tagged with the units that they are named after.
"""

from __future__ import annotations

import json
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.builtin.own_face import fit_scan
from omote.edit.store.import_items import make_document
from omote.interchange.avatar.export_vrm import vrm_bytes
from omote.interchange.avatar.vrm_licence import Credit, parse_terms
from omote.interchange.export_face import named_compound_meshes
from omote.interchange.formats.expression_json import encode
from omote.interchange.formats.glb_reader import Piece, read_glb
from omote.interchange.scans.scan_reader import ScanFile
from omote.model.cast import Cast, Look
from omote.model.fitting.doubt import EYES, Doubt
from omote.model.fitting.find_head import HeadPlacement
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.landmarks import find_landmarks
from omote.model.fitting.scan import Scan
from omote.model.fitting.take_expressions import TakenExpressions
from omote.model.space.expression import Expression
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.compound import compound
from omote.server.sandbox import import_files, scan_faces
from omote.server.sandbox.import_files import (
    PLAIN,
    expressions_from,
    faces_from,
    foreign_expressions,
    is_foreign,
    read_in_sandbox,
)
from tests.interchange.formats.scenes import NAMES, head_glb, plain_glb, put_together, taken_apart
from tests.interchange.scans.scan_samples import ball
from tests.model.fitting.retriangulated import TURN, retriangulate
from tests.stage_data.heads import context

CAST = load_cast()
OLD = CAST.faces["old"]


@pytest.fixture(scope="module")
def built_in() -> Cast:
    """The built-in cast."""
    return load_cast()


def as_obj(points: np.ndarray) -> bytes:
    """Vertices as an OBJ file."""
    return "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()).encode()


def test_a_document_brings_its_expression(built_in: Cast, tmp_path: Path) -> None:
    path = tmp_path / "s.json"
    path.write_bytes(encode(make_document(built_in.space, "Sm", ["t"], built_in.expressions["smile"])))
    ((arrival, sentence),) = expressions_from(built_in, [path])
    assert (arrival.label, arrival.tags, sentence) == ("Sm", ("t",), "Sm, from s.json")


def test_heads_bring_their_targets(built_in: Cast, tmp_path: Path) -> None:
    rest = built_in.faces["dog"].positions.astype(np.float64)
    moved = named_compound_meshes(built_in, "dog", "smile")["skin"] - rest
    path = tmp_path / "dog.glb"
    path.write_bytes(head_glb("skin", rest, {"grin": moved}))
    ((arrival, sentence),) = expressions_from(built_in, [path])
    assert arrival.label == "grin"
    assert sentence.startswith("grin, taken from dog")


def test_what_a_file_leaves_out_is_said_with_its_first_item(built_in: Cast, tmp_path: Path) -> None:
    rest = built_in.faces["dog"].positions.astype(np.float64)
    moved = named_compound_meshes(built_in, "dog", "smile")["skin"] - rest
    document, binary = taken_apart(head_glb("skin", rest, {"grin": moved, "Grin": moved, "bad": moved * np.nan}))
    document["extensionsRequired"] = ["ACME_bones"]
    path = tmp_path / "dog.glb"
    path.write_bytes(put_together(document, binary))
    (_, first), (_, second) = expressions_from(built_in, [path])
    assert "dog: it needs ACME_bones, which is not read here" in first
    assert "the shape 'bad' of the mesh 'skin' holds what is no number: it is left out" in first
    assert "dog: " not in second


def test_a_head_at_rest_is_a_face(built_in: Cast, tmp_path: Path) -> None:
    path = tmp_path / "Aunt.obj"
    path.write_bytes(as_obj(built_in.faces["kaori"].positions.astype(np.float64)))
    for look, expected in (("", "kaori"), ("dog", "dog")):
        ((arrival, sentence),) = faces_from(built_in, [path], look=look)
        assert sentence == "Aunt, a face"
        assert isinstance(arrival.made, tuple)
        face, worn = arrival.made
        assert worn == built_in.looks[expected]
        np.testing.assert_array_equal(face.positions, built_in.faces["kaori"].positions)


@pytest.mark.parametrize("suffix", [".gltf", ".ply", ".obj"])
def test_every_kind_of_mesh_brings_the_same_expression(suffix: str, built_in: Cast, tmp_path: Path) -> None:
    """A glTF with its buffer beside it, and shapes of our head in its order."""
    rest = built_in.faces["dog"].positions.astype(np.float64)
    moved = named_compound_meshes(built_in, "dog", "smile")["skin"].astype(np.float64)
    path = tmp_path / f"grin{suffix}"
    document, binary = taken_apart(head_glb("skin", rest, {"grin": moved - rest}))
    document["buffers"][0]["uri"] = "grin.bin"
    (tmp_path / "grin.bin").write_bytes(binary)
    rows = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in moved.tolist())
    head = f"ply\nformat ascii 1.0\nelement vertex {len(moved)}\n"
    head += "".join(f"property double {axis}\n" for axis in "xyz") + "end_header\n"
    written = {".gltf": json.dumps(document), ".ply": head + rows, ".obj": as_obj(moved).decode()}
    path.write_text(written[suffix])
    ((arrival, sentence),) = expressions_from(built_in, [path])
    assert sentence.startswith("grin, taken from dog")
    assert isinstance(arrival.made, Expression)
    worn = compound(built_in.space, built_in.faces["dog"], arrival.made)
    assert np.abs(worn - moved).max() < 1e-4


def test_shapes_of_one_name_are_refused_for_one_would_be_lost(built_in: Cast, tmp_path: Path) -> None:
    for name in ("grin.obj", "grin.ply"):
        (tmp_path / name).write_bytes(b"v 0 0 0\n")
    with pytest.raises(ValueError, match=r"grin\.obj and .*grin\.ply would both be called 'grin'; rename one"):
        list(expressions_from(built_in, [tmp_path / "grin.obj", tmp_path / "grin.ply"]))


def test_a_head_that_is_no_face_of_the_cast_says_that_its_look_is_not_taken(built_in: Cast, tmp_path: Path) -> None:
    path = tmp_path / "Aunt.obj"
    mixed = (built_in.faces["kaori"].positions + built_in.faces["old"].positions.astype(np.float64)) / 2.0
    path.write_bytes(as_obj(mixed))
    ((arrival, sentence),) = faces_from(built_in, [path])
    assert sentence == f"Aunt, a face; Aunt.obj: {PLAIN}"
    assert isinstance(arrival.made, tuple)
    assert arrival.made[1] == Look()
    ((_, sentence),) = faces_from(built_in, [path], look="dog")
    assert sentence == "Aunt, a face"


def test_what_is_not_there_is_refused(built_in: Cast, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="there is no file"):
        list(expressions_from(built_in, [tmp_path / "a.json"]))
    (tmp_path / "a.json").write_bytes(b"{}")
    with pytest.raises(ValueError, match=r"a\.json: it is JSON of another program; expected an expression of Omote"):
        list(expressions_from(built_in, [tmp_path / "a.json"]))


@pytest.fixture(scope="module")
def scan() -> Scan:
    """Old's head in another topology: looks whose eyeballs are left to bones, an open jaw, and nothing."""

    def moves(name: str) -> NDArray[np.float64]:
        return compound(CAST.space, OLD, CAST.expressions[name]).astype(np.float64) - OLD.positions

    still = np.zeros((CAST.space.vertex_count, 3))
    down = moves("eyeLookDownLeft") + moves("eyeLookDownRight")
    shapes = {"eyeLookUp_L": moves("eyeLookUpLeft"), "lookDown": down, "Agape": moves("jawOpen"), "empty": still}
    return retriangulate(CAST.space, OLD, shapes)


@pytest.fixture(scope="module")
def fitted(scan: Scan) -> tuple[HeadPlacement, Fit]:
    """Where the head of the scan is, and its fit: for all tests that ask what is told of a fit, not how it is made."""
    return fit_scan(CAST.space, scan, landmarks={}, name="head")


def as_pieces(scan: Scan) -> tuple[Piece, ...]:
    """The scan as a reader of meshes gives it."""
    return (Piece("head", scan.positions, None, dict(scan.shapes)),)


@pytest.mark.parametrize("suffix", [".glb", ".vrm"])
def test_shapes_of_strangers_come_in_by_name(
    suffix: str, scan: Scan, fitted: tuple[HeadPlacement, Fit], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    path = (tmp_path / "head").with_suffix(suffix)
    path.write_bytes(b"glTF")

    def fit_again(space: ParameterSpace, asked: Scan, /, *, follow: object, **how: object) -> tuple[HeadPlacement, Fit]:
        """What the same call gave the fixture, which takes half a minute."""
        assert space is CAST.space
        assert asked is scan
        assert how == {"landmarks": {}, "name": "head"}
        return fitted

    monkeypatch.setattr(scan_faces, "fit_scan", fit_again)
    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    monkeypatch.setattr("omote.server.sandbox.import_files.read_in_sandbox", lambda _, **__: as_pieces(scan))
    found = {arrival.label: (arrival, told) for arrival, told in expressions_from(CAST, [path])}
    assert set(found) == {"eyeLookUp_L", "lookDown", "Agape"}
    look, told = found["eyeLookUp_L"]
    assert look.tags == ("eyeLookUpLeft", "gaze")
    assert f"taken from the head in head{suffix}, as eyeLookUpLeft" in told
    assert not isinstance(look.made, tuple)
    np.testing.assert_array_equal(look.made.eyes, CAST.expressions["eyeLookUpLeft"].eyes)
    down, told = found["lookDown"]
    assert down.tags == ("eyeLookDownLeft", "eyeLookDownRight", "gaze")
    assert "as eyeLookDownLeft and eyeLookDownRight" in told
    assert not isinstance(down.made, tuple)
    both = [CAST.expressions[f"eyeLookDown{side}"].eyes for side in ("Left", "Right")]
    np.testing.assert_allclose(down.made.eyes, both[0] + both[1], atol=1e-12)
    agape, told = found["Agape"]
    assert agape.tags == ()
    assert "'empty' moves nothing of the face, so it is left out." in told


def test_what_is_doubtful_of_a_strangers_head_is_told_with_its_shapes(
    scan: Scan, fitted: tuple[HeadPlacement, Fit], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    place, fit = fitted
    doubtful = replace(fit, doubts=(Doubt("Are its eyes shut?", EYES),))
    monkeypatch.setattr(scan_faces, "fit_scan", lambda *_, **__: (place, doubtful))
    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    *_, (_, sentence) = foreign_expressions(CAST, tmp_path / "head.glb")
    assert "Are its eyes shut?" in sentence


def test_the_shapes_of_an_animal_are_taken_from_the_fit_that_makes_its_face(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With clicks that make its face of a dog: the same clicks begin the fit that gives its expressions."""
    dog = CAST.faces["dog"]
    still = np.zeros((CAST.space.vertex_count, 3))
    scan = retriangulate(CAST.space, dog, {"still": still})
    clicks = {name: 100.0 * dog.positions[row] @ TURN.T for name, row in find_landmarks(CAST.space).items()}

    def tell_kind(_: object, fitted: Fit, __: object) -> TakenExpressions:
        return TakenExpressions({}, (f"It began from {fitted.kind}.",))

    monkeypatch.setattr(scan_faces, "take_expressions", tell_kind)
    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    with pytest.raises(ValueError, match=r"It began from dog\."):
        list(foreign_expressions(CAST, tmp_path / "dog.glb", landmarks=clicks))


def test_heads_of_ours_are_not_foreign(scan: Scan) -> None:
    rest = OLD.positions.astype(np.float64)
    assert is_foreign(CAST, as_pieces(scan))
    assert is_foreign(CAST, as_pieces(replace(scan, shapes={})))
    assert not is_foreign(CAST, (Piece("skin", rest, None, {"grin": np.zeros_like(rest)}),))


def test_a_head_without_shapes_is_refused(scan: Scan, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:

    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(replace(scan, shapes={})))
    with pytest.raises(ValueError, match=r"head\.glb: the head has no shapes .* omote face head\.glb -o show\.omote"):
        list(foreign_expressions(CAST, tmp_path / "head.glb"))


def test_what_may_be_no_face_is_asked_about_and_brings_nothing(
    scan: Scan, fitted: tuple[HeadPlacement, Fit], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:  # fmt: skip
    """A ball with a shape, and a head that is found with a doubt."""
    points, triangles = ball()
    odd = Scan(points, triangles, shapes={"jawOpen": 0.1 * points})
    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(odd))
    with pytest.raises(ValueError, match=r"ball\.glb: nothing in the scan could be a face.*export the head alone"):
        list(foreign_expressions(CAST, tmp_path / "ball.glb"))

    monkeypatch.setattr(import_files, "read_scan_in_sandbox", lambda _: ScanFile(scan))
    place, fit = fitted
    doubtful = replace(place, doubts=(Doubt("This may be no face."),))
    monkeypatch.setattr(scan_faces, "fit_scan", lambda *_, **__: (doubtful, fit))
    with pytest.raises(ValueError, match=r"fox\.glb: This may be no face\. Say where the head is, with --landmarks"):
        list(foreign_expressions(CAST, tmp_path / "fox.glb"))


def test_pieces_come_back_whole(tmp_path: Path) -> None:
    path = tmp_path / "a.GLB"
    path.write_bytes(plain_glb())
    (piece,) = read_in_sandbox(path)
    assert piece.name == "tetra"
    assert tuple(piece.moves) == NAMES
    assert piece.rows is not None
    np.testing.assert_array_equal(piece.rows, [3, 2, 1, 0])
    assert piece.points.shape == (4, 3)


def test_a_shape_comes_back(tmp_path: Path) -> None:
    path = tmp_path / "a.obj"
    path.write_bytes(b"v 1 2 3\nv 4 5 6\n")
    (piece,) = read_in_sandbox(path)
    np.testing.assert_array_equal(piece.points, [[1, 2, 3], [4, 5, 6]])
    assert piece.rows is None


@pytest.mark.parametrize("suffix", [".vrm", ".glb"])
def test_shapes_of_an_avatar_come_back_as_its_expressions(suffix: str, tmp_path: Path) -> None:
    cast = context().cast
    path = tmp_path / f"broad{suffix}"
    poses = [(name, named_compound_meshes(cast, "broad", name)) for name in ("smile", "jawOpen")]
    path.write_bytes(vrm_bytes(context(), "broad", poses, Credit(("Ann",), parse_terms(["strict"]))))
    found, raw = (
        {name: moved for piece in pieces if piece.name == "skin" for name, moved in piece.moves.items()}
        for pieces in (read_in_sandbox(path), read_glb(path.read_bytes()))
    )
    kinds = taken_apart(path.read_bytes())[0]["extensions"]["VRMC_vrm"]["expressions"]
    assert {"relaxed", "JawOpen"} <= found.keys() <= {*kinds["preset"], *kinds["custom"]}
    assert "jawOpen" in raw
    np.testing.assert_array_equal(found["JawOpen"], raw["jawOpen"])
    np.testing.assert_array_equal(found["relaxed"], raw["smile"])


def test_what_no_reader_takes_is_told_with_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.glb"
    path.write_bytes(b"hello")
    with pytest.raises(ValueError, match=r"a\.glb: the file is no GLB"):
        read_in_sandbox(path)
    with pytest.raises(ValueError, match=r"a\.fbx: the file is no head with shapes: export it as \.glb or \.obj"):
        read_in_sandbox(tmp_path / "a.fbx")


@pytest.mark.parametrize("kind", ["memory", "death", "files"])
def test_a_reader_that_takes_too_much_or_dies_harms_nobody(
    kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def hungry(_: bytes, *__: object) -> tuple[Piece, ...]:
        if kind == "memory":
            return (Piece("x", np.ones((2**31, 3))),)
        if kind == "death":
            os._exit(3)
        (tmp_path / "stray").write_bytes(b"x" * 10_000)
        return ()

    path = tmp_path / "a.glb"
    path.write_bytes(b"x")
    monkeypatch.setattr(import_files, "READERS", {".glb": hungry})
    with pytest.raises(ValueError, match="needs more time or memory than any face"):
        read_in_sandbox(path)
    stray = tmp_path / "stray"
    assert not stray.exists() or stray.stat().st_size == 0
