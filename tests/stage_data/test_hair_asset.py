"""A page reads the strands that the cast has, to well below what anybody sees."""

import dataclasses

import numpy as np
import pytest

from omote.model.cast import Cast, Look
from omote.stage_data.assets import HAIR_STEP, documents, hair_asset
from tests.model.tufts import tuft


def test_strands_come_back_as_they_are() -> None:
    style = tuft()
    asset = hair_asset(tuft())
    points = np.frombuffer(asset.points, "<i2").reshape(style.points.shape) * asset.scale
    assert np.abs(points - style.points).max() <= 0.5001 * HAIR_STEP
    counts = np.frombuffer(asset.weights, "u1").reshape(style.weights.shape).astype(float)
    assert counts / counts.sum(axis=2, keepdims=True) == pytest.approx(style.weights, abs=0.02)
    assert np.array_equal(np.frombuffer(asset.rows, "<u4").reshape(style.rows.shape), style.rows)
    assert np.array_equal(np.frombuffer(asset.anchors, "<u4"), style.anchors)
    assert np.frombuffer(asset.light, "u1").reshape(style.light.shape) / 255 == pytest.approx(style.light, abs=0.003)
    assert np.frombuffer(asset.fullness, "u1") / 255 == pytest.approx(style.fullness, abs=0.003)
    assert (asset.stations, asset.links, asset.width) == (style.points.shape[1], style.rows.shape[2], style.width)


def test_the_manifest_says_who_wears_which_style_and_where_it_is(cast: Cast) -> None:
    worn = dataclasses.replace(cast, hair={"tuft": tuft()}).with_faces(looks={"broad": Look(hair_style="tuft")})
    packed = documents(worn, [], mask="")
    assert {face.name: face.look.hair_style for face in packed.manifest.faces} == {
        "generic": "",
        "broad": "tuft",
        "long": "",
    }
    assert {hair.name: packed.hair[hair.url] for hair in packed.manifest.hair} == {"tuft": hair_asset(tuft())}


def test_the_picture_holds_the_hair(cast: Cast) -> None:
    worn = dataclasses.replace(cast, hair={"tuft": tuft()}).with_faces(looks={"broad": Look(hair_style="tuft")})
    bald, combed = (
        {face.name: max(point[1] for point in face.extremes) for face in documents(each, [], mask="").manifest.faces}
        for each in (cast, worn)
    )
    assert combed["broad"] > bald["broad"]
    assert combed["long"] == bald["long"]
