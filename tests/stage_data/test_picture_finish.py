"""Finished pictures: means and contrasts that match, hues that stay, and masks that hold the face."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import omote
from omote.arrays import Picture, Values
from omote.model.albedo import decode_light
from omote.stage_data.picture_finish import face_triangles, finish_picture, measure_luminance
from omote.stage_data.picture_setting import Clipped, Setting

SIDE = 48
SPACE = omote.load_cast().space


def finish(*given: Any) -> Picture:
    """The picture that `finish_picture` makes."""
    return finish_picture(*given).picture


def random_picture(seed: int) -> Picture:
    """Colours from dark to light, part of it transparent."""
    draw = np.random.default_rng(seed)
    picture = (draw.beta(0.8, 1.6, (SIDE, SIDE, 4)) * 255).astype(np.uint8)
    picture[..., 3] = draw.choice([0, 128, 255], (SIDE, SIDE))
    return picture


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("luminance", "contrast"), [(0.2, 0.5), (0.4, 0.3), (0.05, 0.8), (0.3, None), (None, 0.2)])
def test_means_and_contrasts_match_whatever_was_drawn(
    seed: int, luminance: float | None, contrast: float | None
) -> None:
    before = random_picture(seed)
    after = finish(before, Setting(SIDE, SIDE, transparent=True, luminance=luminance, contrast=contrast))
    first, last = measure_luminance(before), measure_luminance(after)
    wanted = first.mean if luminance is None else luminance
    assert abs(last.mean - wanted) < 1 / 255
    assert abs(last.mean * last.contrast - wanted * (first.contrast if contrast is None else contrast)) < 1 / 255
    assert np.array_equal(after[..., 3], before[..., 3])
    assert np.array_equal(after[before[..., 3] == 0], before[before[..., 3] == 0])


def test_a_colour_keeps_its_hue_and_what_it_cannot_have_is_refused() -> None:
    picture = np.full((SIDE, SIDE, 4), (120, 60, 30, 255), np.uint8)
    picture[: SIDE // 2, :, :3] //= 2
    darker = decode_light(finish(picture, Setting(SIDE, SIDE, luminance=0.02))[..., :3])
    shares = darker / darker.sum(axis=-1, keepdims=True)
    wanted = decode_light(picture[..., :3]) / decode_light(picture[..., :3]).sum(axis=-1, keepdims=True)
    np.testing.assert_allclose(shares, wanted, atol=0.02)
    with pytest.raises(ValueError, match=r"cannot have a mean luminance of 0\.9 and a contrast of 2: the nearest is"):
        finish(picture, Setting(SIDE, SIDE, luminance=0.9, contrast=2.0))


def test_what_is_cut_off_to_match_is_told_as_black_and_white() -> None:
    picture = np.full((20, 20, 4), 255, np.uint8)
    picture[..., :3] = np.linspace(40, 230, 400).astype(np.uint8).reshape(20, 20, 1)
    assert finish_picture(picture, Setting(20, 20)).clipped is None
    assert finish_picture(picture, Setting(20, 20, luminance=0.2)).clipped == Clipped(0.0, 0.0)
    much, clipped = finish_picture(picture, Setting(20, 20, luminance=0.4, contrast=0.95))
    assert clipped is not None
    assert min(clipped.black, clipped.white) > 0.1
    assert (clipped.black, clipped.white) == pytest.approx(
        ((much[..., :3] == 0).mean(), (much[..., :3] == 255).mean()), abs=0.02
    )


def places() -> Values:
    """Where the generic face lies in a picture from straight ahead."""
    skin = SPACE.points
    return np.column_stack([0.5 + 3.0 * skin[:, 0], 0.5 - 3.0 * skin[:, 1], np.full(len(skin), 1.0)])


@pytest.mark.parametrize("mask", ["oval", "face"])
def test_a_mask_leaves_the_face_and_nothing_around_it(mask: str) -> None:
    triangles = face_triangles(SPACE)
    white = np.full((4 * SIDE, 4 * SIDE, 4), 255, np.uint8)
    setting = Setting(4 * SIDE, 4 * SIDE, mask=mask, transparent=True)
    alpha = finish(white, setting, places(), triangles)[..., 3]
    x, y = (4 * SIDE * places()[:, :2]).astype(int).T
    eyes, lips = (
        np.unique(np.concatenate([line.loop for line in SPACE.lines if line.kind == kind])) for kind in ("lids", "lips")
    )
    for row in (*eyes, *lips):
        assert alpha[y[row], x[row]] == 255
    middle_of_the_eye = SPACE.parts["eye_left"].points.mean(axis=0)
    column, row = (int(4 * SIDE * (0.5 + sign * 3.0 * middle_of_the_eye[axis])) for axis, sign in ((0, 1), (1, -1)))
    assert alpha[row, column] == 255, "an opening belongs to the face"
    crown = int(SPACE.points[:, 1].argmax())
    assert alpha[y[crown], x[crown]] == 0
    assert (alpha[:, [0, -1]] == 0).all()
    assert 0.15 < alpha.mean() / 255 < 0.35
    grey = finish(white, Setting(4 * SIDE, 4 * SIDE, mask=mask, background="#808080"), places(), triangles)
    assert (grey[alpha == 0] == (128, 128, 128, 255)).all()
    assert (grey[alpha == 255] == 255).all()


def test_a_background_comes_behind_what_was_matched_and_does_not_count() -> None:
    picture = random_picture(0)
    wish: dict[str, Any] = {"luminance": 0.3, "contrast": 0.4}
    clear = finish(picture, Setting(SIDE, SIDE, transparent=True, **wish))
    on_green = finish(picture, Setting(SIDE, SIDE, background="#00b140", **wish))
    assert np.array_equal(on_green[picture[..., 3] == 255], clear[picture[..., 3] == 255])
    assert (on_green[picture[..., 3] == 0] == (0, 0xB1, 0x40, 255)).all()
