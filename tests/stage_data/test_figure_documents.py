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
