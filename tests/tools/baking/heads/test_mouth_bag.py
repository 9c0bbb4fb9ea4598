"""The mouth bag of baked units goes with the jaws and stays behind the skin."""

import numpy as np

import omote
from omote.model.transfer.gum_line import find_gum_line
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.transfer.mouth_bag_fit import measure_depths, missing_depths, require_depths
from tests.synthetic import space
from tools.baking.heads.mouth_bag import carry_bag, keep_bag_inside

CAST = omote.load_cast()
LINE = find_gum_line(CAST.space)


def test_a_carried_displacement_moves_the_gums_with_the_teeth_and_leaves_all_other_skin() -> None:
    assert LINE is not None
    rng = np.random.default_rng(75)
    skin = rng.normal(0, 0.001, CAST.space.points.shape)
    teeth = CAST.space.parts["teeth_lower"].points
    turned = 0.1 * (teeth - teeth.mean(axis=0))[:, [0, 2, 1]] * [1, 1, -1]
    moved = carry_bag(CAST.space, skin[CAST.space.welded], turned)
    others = np.setdiff1d(CAST.space.welded, LINE.bag.vertices)
    assert np.array_equal(moved[others], skin[CAST.space.welded][others])
    lower = LINE.edge & (LINE.names == "teeth_lower")
    lining = (LINE.weights[..., None] * moved[LINE.corners]).sum(axis=1)[lower]
    assert np.quantile(np.linalg.norm(lining - turned[LINE.rows[lower]], axis=1), 0.9) < 0.0005


def test_a_space_without_gums_keeps_the_displacement_itself() -> None:
    displaced = np.ones_like(space().points)
    assert carry_bag(space(), displaced, np.zeros((3, 3))) is displaced


def test_a_displacement_is_kept_but_for_the_bag() -> None:
    head = CAST.space
    still = np.zeros((head.vertex_count, 3))
    assert not keep_bag_inside(head, still).any()
    bag = find_mouth_bag(head)
    assert bag is not None
    out = still.copy()
    out[bag.vertices, 2] = 0.01
    kept = keep_bag_inside(head, out)
    assert not kept[head.on_sheet].any()
    lack = missing_depths(require_depths(head, bag), measure_depths(head, bag, head.points + kept))
    assert lack.max() < 2e-4
