"""Masks of the play regions: they share everything, and lids, lips and what is rigid belong to one whole."""

import numpy as np
import pytest

import omote
from omote.model.known_names import PLAY_REGIONS
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.perform.blending.region_masks import play_masks

CAST = omote.load_cast()
MASKS = play_masks(CAST.space)


def test_the_regions_share_everything_and_are_made_once() -> None:
    assert play_masks(CAST.space) is MASKS
    regions = find_corrective_regions(CAST.space)
    assert regions is not None
    for shares, size in (
        ([MASKS[region].skin for region in PLAY_REGIONS], (CAST.space.vertex_count, 1)),
        ([MASKS[region].allowances for region in PLAY_REGIONS], (regions.size,)),
        *(
            ([MASKS[region].parts[name] for region in PLAY_REGIONS], (len(part.points), 1))
            for name, part in CAST.space.parts.items()
        ),
    ):
        assert all(share.shape == size and (share >= 0.0).all() for share in shares)
        assert np.allclose(sum(shares), 1.0, atol=1e-6)


def test_lids_belong_to_the_eyes_and_lips_to_the_mouth_whole() -> None:
    for line in CAST.space.lines:
        region = MASKS["mouth" if line.name == "lips" else "eyes"]
        assert (region.skin[line.loop] == 1.0).all()


@pytest.mark.parametrize("part", ["teeth_upper", "teeth_lower", "tongue"])
def test_what_lies_in_the_mouth_belongs_to_it_whole(part: str) -> None:
    assert (MASKS["mouth"].parts[part] == 1.0).all()


@pytest.mark.parametrize("part", ["eye_left", "eye_right"])
def test_eyeballs_belong_to_the_eyes_whole(part: str) -> None:
    assert (MASKS["eyes"].parts[part] == 1.0).all()


def test_borders_are_wide_enough_for_a_brow_over_a_still_eye() -> None:
    a, b = CAST.space.skin_triangles[:, :2].T
    length = np.linalg.norm(CAST.space.points[a] - CAST.space.points[b], axis=1)
    for region, mask in MASKS.items():
        assert (np.abs(mask.skin[a, 0] - mask.skin[b, 0]) <= length / 0.006).all(), region
