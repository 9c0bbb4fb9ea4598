"""Teeth, gums and palate in the cage of the cast's rows: whatever moves the rows moves them alike."""

import json
import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.builtin import load_cast
from omote.geometry import mesh
from omote.interchange.part_textures import ARCH
from omote.interchange.teeth_sheet import COLUMN_ROWS, COLUMNS, TeethSheet, cage_columns, cage_weights, teeth_sheet
from omote.interchange.tooth_profiles import RIBS, TEETH
from omote.model.cast import Look
from omote.model.transfer.gum_line import GUMS
from tools.node import ROOT, find_node

SPACE = load_cast().space
BOTH = pytest.mark.parametrize("name", [*GUMS])


LOOKS = {"person": Look(), "milk": Look(milk=1.0), "carnivore": Look(fur=1.0)}


def sheet_of(name: str, look: Look) -> TeethSheet:
    found = teeth_sheet(SPACE.parts[name].points, upper=name == "teeth_upper", look=look)
    assert found is not None
    return found


@BOTH
def test_columns_are_found_in_whatever_order_rows_come(name: str) -> None:
    points = SPACE.parts[name].points
    columns = cage_columns(points, upper=name == "teeth_upper")
    assert columns is not None
    assert sorted(columns.ravel()) == list(range(COLUMNS * COLUMN_ROWS))
    order = np.random.default_rng(3).permutation(len(points))
    found = cage_columns(points[order], upper=name == "teeth_upper")
    assert found is not None
    np.testing.assert_array_equal(order[found], columns)
    edges = points[columns[:, 2]] - points.mean(axis=0)
    assert (np.diff(np.arctan2(edges[:, 0], edges[:, 2])) > 0.0).all(), "from the right end to the left"
    assert cage_columns(points[1:], upper=True) is None


@BOTH
@given(st.integers(0, 10**6))
def test_places_go_along_with_whatever_moves_all_rows_alike(name: str, seed: int) -> None:
    chance = np.random.default_rng(seed)
    points = SPACE.parts[name].points
    columns = cage_columns(points, upper=name == "teeth_upper")
    assert columns is not None
    places = np.column_stack([chance.uniform(0, 16, 9), chance.uniform(-0.5, 1.5, 9), chance.uniform(-0.2, 1.5, 9)])
    weights = cage_weights(columns, places)
    np.testing.assert_allclose(weights.sum(axis=1), 1.0, atol=1e-12)
    matrix = np.eye(3) + chance.normal(0, 0.2, (3, 3))
    shift = chance.normal(0, 0.05, 3)
    np.testing.assert_allclose(weights @ (points @ matrix + shift), weights @ points @ matrix + shift, atol=1e-12)


@BOTH
@pytest.mark.parametrize("look", [*LOOKS.values(), Look(fur=0.5), Look(milk=0.5)])
def test_a_sheet_faces_outwards_and_is_the_same_on_both_sides(name: str, look: Look) -> None:
    sheet = sheet_of(name, look)
    points = sheet.weights @ SPACE.parts[name].points
    columns = points.reshape(-1, RIBS, 3)
    np.testing.assert_allclose(columns[::-1] * [-1, 1, 1], columns, atol=3e-5)
    assert set(np.floor(sheet.numbers).astype(int)) == set(range(2 * TEETH + 1))
    np.testing.assert_allclose(sheet.heights.reshape(-1, RIBS)[::-1], sheet.heights.reshape(-1, RIBS), atol=1e-12)
    normals = mesh.normals(points, sheet.triangles)
    middle = (np.abs(sheet.numbers - (TEETH + 0.5)) < 1e-9) & (sheet.heights == 0.5)
    assert (normals[middle, 2] > 0.5).any(), "a front tooth faces out of the head"
    edges = (np.abs(sheet.numbers - (TEETH + 0.5)) < 1e-9) & (sheet.heights == 1.0)
    assert (normals[edges, 1] * (-1.0 if name == "teeth_upper" else 1.0)).max() > 0.3, "an edge faces the other row"


@BOTH
@pytest.mark.parametrize("look", LOOKS.values(), ids=LOOKS)
def test_a_row_ends_in_gum_that_sinks_to_nothing(name: str, look: Look) -> None:
    sheet = sheet_of(name, look)
    points = 1e3 * (sheet.weights @ SPACE.parts[name].points).reshape(-1, RIBS, 3)
    heights = sheet.heights.reshape(-1, RIBS)
    for end in (0, -1):
        assert (heights[end] < 0.0).all(), "no crown is cut open"
        ridge = points[end, : RIBS - 2]
        assert np.ptp(ridge[:, 1]) < 4.0, "gum at the level of palate or floor, that falls as the jaw does"
        assert np.linalg.norm(np.diff(ridge, axis=0), axis=1).max() < 1.5, "flat from side to side"


@BOTH
def test_a_baby_has_two_small_teeth_a_side_and_gum_behind_them(name: str) -> None:
    baby, grown = (sheet_of(name, LOOKS[whose]) for whose in ("milk", "person"))
    number = np.abs(baby.numbers - TEETH)
    for sheet, last in ((baby, 2.0), (grown, float(TEETH))):
        assert number[sheet.heights > 0.5].max() == pytest.approx(last, abs=0.5)
    height = {}
    for sheet in (baby, grown):
        points = sheet.weights @ SPACE.parts[name].points
        crown = (sheet.heights >= 0.0) & (number < 1.0)
        height[sheet is baby] = np.ptp(points[crown, 1])
    assert height[True] < 0.7 * height[False]


SCRIPT = """
import {{ cageColumns, cagePoint }} from "{web}/face/head/teeth_cage";
import {{ teethSheet }} from "{web}/face/head/teeth_sheet";
const {{ points, upper, arch }} = {given};
const positions = Float32Array.from(points);
const columns = cageColumns([...Array(68).keys()], positions, upper, arch);
const sheet = teethSheet(columns, positions, upper);
const placed = ({{ places }}) =>
  Array.from({{ length: places.length / 3 }}, (_, n) =>
    cagePoint(columns, positions, places.subarray(3 * n, 3 * n + 3)));
const found = {{ person: placed(sheet.person), milk: placed(sheet.milk), carnivore: placed(sheet.carnivore) }};
console.log(JSON.stringify({{ ...found, marks: [...sheet.marks], triangles: [...sheet.triangles] }}));
"""


def as_stages_have_it(name: str, folder: Path) -> dict[str, Any]:
    """The sheet of the generic face as the stages' own code makes it."""
    path = find_node()
    assert path is not None
    points = SPACE.parts[name].points.astype(np.float32)
    given = {"points": points.ravel().tolist(), "upper": name == "teeth_upper", "arch": ARCH}
    entry = folder / "entry.ts"
    entry.write_text(SCRIPT.format(web=ROOT / "web" / "src", given=json.dumps(given)))
    environment = {**os.environ, "PATH": path}
    bundle = ["node_modules/.bin/rolldown", str(entry), "--file", str(folder / "sheet.mjs"), "--format", "esm"]
    for command in (bundle, ["node", str(folder / "sheet.mjs")]):
        done = subprocess.run(command, cwd=ROOT / "web", env=environment, capture_output=True, text=True, check=True)
    found: dict[str, Any] = json.loads(done.stdout)
    return found


@BOTH
def test_stages_draw_the_same(name: str, tmp_path: Path) -> None:
    theirs = as_stages_have_it(name, tmp_path)
    marks = np.array(theirs["marks"]).reshape(-1, 4)
    triangles = set(map(tuple, np.array(theirs["triangles"]).reshape(-1, 3).tolist()))
    own = marks[:, 2] == 0.0  # palate and floor go to the other side in the shader
    for whose, look in LOOKS.items():
        sheet = sheet_of(name, look)
        heights = marks[:, 3] if whose == "milk" else marks[:, 0]
        np.testing.assert_allclose(sheet.heights, heights, atol=1e-6)
        np.testing.assert_allclose(sheet.numbers, marks[:, 1], atol=1e-6)
        assert set(map(tuple, sheet.triangles.tolist())) == triangles
        placed = sheet.weights @ SPACE.parts[name].points
        np.testing.assert_allclose(placed[own], np.array(theirs[whose])[own], atol=1e-6)
