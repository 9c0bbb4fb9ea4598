"""The welcome to editors decodes to what the model says."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.edit.compute import welcome
from omote.edit.compute.welcome import build_welcome, followers
from omote.edit.protocol.wire import encode
from omote.model.controls.face_muscles import muscle_fields
from omote.model.space.head_regions import REGIONS, region_weights

CAST = omote.load_cast()


def test_followers_move_with_the_sheet_as_the_bindings_say() -> None:
    space = CAST.space
    rows, anchors, shares = followers(space)
    assert space.on_sheet[anchors[shares > 0]].all()
    assert set(space.inner.vertices) <= set(rows.tolist())
    move = np.random.default_rng(0).normal(size=(space.vertex_count, 3)) * space.on_sheet[:, None]
    found = np.zeros((space.vertex_count + sum(len(part.points) for part in space.parts.values()), 3))
    found[rows] = np.einsum("fk,fkc->fc", shares, move[anchors])
    inner = space.inner
    expected = np.einsum("fk,fkc->fc", inner.weights, move[inner.anchors])
    assert np.allclose(found[inner.vertices], expected, atol=1e-6)
    whole = move.copy()
    whole[inner.vertices] = expected
    first = space.vertex_count
    for part in space.parts.values():
        last = first + len(part.points)
        assert np.allclose(found[first:last], np.einsum("nk,nkc->nc", part.weights, whole[part.anchors]), atol=1e-6)
        first = last


def test_the_welcome_says_which_downloads_cannot_be_made_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(welcome, "unwritable_kinds", lambda: {".usdz": "usd-core is missing"})
    assert build_welcome(CAST).unwritable == {"usdz": "usd-core is missing"}


def test_masks_and_muscles_decode_to_what_they_are() -> None:
    told = build_welcome(CAST)
    masks = np.frombuffer(told.masks, np.uint8).reshape(len(REGIONS), -1) / 255.0
    weights = region_weights(CAST.space)
    assert told.regions == list(REGIONS)
    assert np.abs(masks - np.stack([weights[region] for region in REGIONS])).max() <= 0.5 / 255 + 1e-12
    for muscle in told.muscles:
        field = np.frombuffer(muscle.field, "<f4").reshape(-1, 3)
        assert np.allclose(field, muscle_fields(CAST.space)[muscle.name], atol=1e-7)
    assert told.digest == CAST.digest
    assert len(encode(told)) < 2**21
