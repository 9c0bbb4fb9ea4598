"""Figures for the pages say what the engine has."""

from __future__ import annotations

import numpy as np

from omote.builtin import load_figures
from omote.show.cast_documents import BodyAsset, FigureAsset
from omote.stage_data.figure_documents import figure_documents


def test_pages_read_the_figures_that_the_engine_has() -> None:
    figures = load_figures()
    packed = figure_documents(figures)
    shared = packed.assets[packed.document.url]
    assert isinstance(shared, FigureAsset)
    space = figures.space
    rows = len(space.bones)
    np.testing.assert_array_equal(np.frombuffer(shared.row_bones, np.uint8).reshape(rows, -1), space.bones)
    weights = np.frombuffer(shared.row_weights, "<u2").reshape(rows, -1) / 65535
    np.testing.assert_allclose(weights, space.weights, atol=1e-5)
    assert tuple(shared.bones) == space.skeleton.names
    np.testing.assert_array_equal(np.frombuffer(shared.limb_rows, "<u4"), figures.limbs.rows)
    np.testing.assert_array_equal(np.frombuffer(shared.limbs, np.uint8), figures.limbs.limbs)
    np.testing.assert_allclose(np.frombuffer(shared.limb_ways, "<f4"), figures.limbs.ways, atol=1e-6)
    for sent, field in zip(shared.limb_fields, figures.limb_fields.values(), strict=True):
        values = np.zeros_like(field.values)
        values[np.frombuffer(sent.places, "<u4")] = np.frombuffer(sent.values, "<f4").reshape(-1, 3)
        np.testing.assert_array_equal(values, field.values)
        assert (sent.name, sent.driver) == (field.name, field.driver)
    for document in packed.document.bodies:
        asset = packed.assets[document.url]
        assert isinstance(asset, BodyAsset)
        body = figures.bodies[document.name]
        for what in ("positions", "edge", "joints", "ends"):
            read = np.frombuffer(getattr(asset, what), "<f4").reshape(-1, 3)
            np.testing.assert_array_equal(read, getattr(body, what))
    for told in packed.document.poses:
        pose = figures.poses[told.name]
        np.testing.assert_allclose(np.frombuffer(told.turns, "<f4").reshape(-1, 3), pose.turns, atol=1e-6)
        np.testing.assert_allclose(np.frombuffer(told.feet, "<f4").reshape(-1, 3), pose.feet, atol=1e-6)
        np.testing.assert_allclose(told.travel, pose.travel)
