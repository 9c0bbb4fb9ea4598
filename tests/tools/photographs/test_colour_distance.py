"""CIE delta E 2000, beside the pairs that its authors published."""

from __future__ import annotations

import numpy as np
import pytest

from tools.photographs.colour_distance import colour_distance, delta_e

# Sharma, Wu and Dalal (2005), table 1: two colours in L*a*b*, and how far they are from each other.
PUBLISHED = np.array([
    [50.0, 2.6772, -79.7751, 50.0, 0.0, -82.7485, 2.0425],
    [50.0, -1.3802, -84.2814, 50.0, 0.0, -82.7485, 1.0],
    [50.0, 0.0, 0.0, 50.0, -1.0, 2.0, 2.3669],
    [50.0, 2.49, -0.001, 50.0, -2.49, 0.0009, 7.1792],
    [50.0, 2.49, -0.001, 50.0, -2.49, 0.0011, 7.2195],
    [50.0, 2.5, 0.0, 73.0, 25.0, -18.0, 27.1492],
    [50.0, 2.5, 0.0, 50.0, 3.2592, 0.335, 1.0],
    [60.2574, -34.0099, 36.2677, 60.4626, -34.1751, 39.4387, 1.2644],
    [22.7233, 20.0904, -46.694, 23.0331, 14.973, -42.5619, 2.0373],
    [90.8027, -2.0831, 1.441, 91.1528, -1.6435, 0.0447, 1.4441],
    [2.0776, 0.0795, -1.135, 0.9033, -0.0636, -0.5514, 0.9082],
])  # fmt: skip


def test_published_pairs_are_as_far_apart_as_published() -> None:
    one = PUBLISHED[:, :3]
    other = PUBLISHED[:, 3:6]
    far = PUBLISHED[:, 6]
    assert colour_distance(one, other) == pytest.approx(far, abs=5e-5)
    assert colour_distance(other, one) == pytest.approx(far, abs=5e-5)


def test_a_picture_in_a_weaker_light_is_the_same_and_another_hue_is_not() -> None:
    draw = np.random.default_rng(3)
    truth = draw.integers(90, 250, (40, 40, 3)).astype(np.uint8)
    darker = (255.0 * (truth / 255.0) * 0.7).round().astype(np.uint8)  # about a power of the light: hues stay
    seen = np.ones((40, 40), bool)
    assert delta_e(truth, truth, seen) == 0.0
    assert delta_e(darker, truth, seen) < 2.0
    assert delta_e(np.ascontiguousarray(truth[..., ::-1]), truth, seen) > 10.0


def test_only_what_was_seen_counts() -> None:
    truth = np.full((4, 4, 3), 128, np.uint8)
    wrong = truth.copy()
    wrong[0, 0] = (255, 0, 0)
    seen = np.ones((4, 4), bool)
    seen[0, 0] = False
    assert delta_e(wrong, truth, seen) == 0.0
