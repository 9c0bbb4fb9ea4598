"""Expressions on a face as tables of numbers."""

import csv
import io
from pathlib import Path

import numpy as np
import pytest

from omote.interchange.export_deltas import COLUMNS, Deltas, encode_deltas, measure_deltas
from omote.interchange.export_face import named_compound_meshes
from omote.interchange.formats.atomic_file import SIGNATURES
from omote.model.cast import Cast
from omote.model.transfer.compound import compound

NAMES = ("smile", "jawOpen")


@pytest.fixture
def deltas(cast: Cast) -> Deltas:
    poses = [(name, named_compound_meshes(cast, "broad", name)) for name in NAMES]
    return measure_deltas(cast, "broad", poses)


def test_rest_and_deltas_are_the_compound(cast: Cast, deltas: Deltas) -> None:
    with np.load(io.BytesIO(encode_deltas(deltas, Path("a.npz")))) as file:
        assert [*file["expressions"]] == [*NAMES]
        assert [*file["facs"]] == ["", "26"]
        assert (str(file["face"]), str(file["cast"])) == ("broad", cast.digest)
        for number, name in enumerate(NAMES):
            wanted = compound(cast.space, cast.faces["broad"], cast.expressions[name])
            np.testing.assert_allclose(file["rest"] + file["deltas"][number], wanted, atol=1e-6)
        assert {f"{part}/deltas" for part in cast.space.parts} <= set(file.files)
        np.testing.assert_array_equal(file["triangles"], cast.space.triangles)


def test_a_table_has_a_line_for_each_vertex_that_moves(cast: Cast, deltas: Deltas) -> None:
    data = encode_deltas(deltas, Path("a.csv"))
    lines = list(csv.DictReader(io.StringIO(data.decode())))
    assert tuple(lines[0]) == COLUMNS
    again = {name: np.zeros_like(deltas.rest["skin"]) for name in NAMES}
    for line in lines:
        move = [float(line[axis]) for axis in ("dx", "dy", "dz")]
        assert any(move)
        if line["mesh"] == "skin":
            again[line["expression"]][int(line["vertex"])] = move
    for number, name in enumerate(NAMES):
        np.testing.assert_array_equal(again[name], deltas.moves["skin"][number])


def test_the_same_numbers_are_the_same_bytes(deltas: Deltas) -> None:
    for path in (Path("a.npz"), Path("a.csv")):
        data = encode_deltas(deltas, path)
        assert data == encode_deltas(deltas, path)
        assert data.startswith(SIGNATURES[path.suffix][1])


def test_another_ending_is_refused(deltas: Deltas) -> None:
    with pytest.raises(ValueError, match=r"'a\.xls' is no name of a table of deltas; end it with \.npz or \.csv"):
        encode_deltas(deltas, Path("a.xls"))
