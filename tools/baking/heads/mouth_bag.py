"""The mouth bag of a unit that is baked: carried by the jaws, and kept behind the skin."""

from __future__ import annotations

import numpy as np

from omote.arrays import Values
from omote.model.space.parameter_space import ParameterSpace
from omote.model.transfer.gum_line import find_gum_line, share_jaws
from omote.model.transfer.mouth_bag import find_mouth_bag
from omote.model.transfer.mouth_bag_fit import push_inside, require_depths


def carry_bag(space: ParameterSpace, skin: Values, teeth: Values, /) -> Values:
    """A displacement of the generic skin (V, 3) with the mouth bag carried by the jaws.

    space: the space of the generic head.

    teeth: what the lower teeth do, displacements (n, 3): as an affine map (least squares) it says what happens around
    them. Shares of the upper jaw stay.
    """
    line = find_gum_line(space)
    if line is None:
        return skin
    upper, lower = (share[:, None] for share in share_jaws(space, line))
    points = space.parts["teeth_lower"].points
    bag = line.bag.vertices
    ones = np.ones((len(points), 1))
    affine, *_ = np.linalg.lstsq(np.hstack([points, ones]), teeth, rcond=None)
    around = np.hstack([space.points[bag], np.ones((len(bag), 1))]) @ affine
    result = skin.copy()
    result[bag] = (1.0 - upper - lower) * skin[bag] + lower * around
    return result[space.welded]


def keep_bag_inside(space: ParameterSpace, displacement: Values, /) -> Values:
    """A displacement of the generic skin (V, 3) with the mouth bag as far behind the moved skin as on any face.

    space: the space of the generic head.

    A unit whose bag comes out of the generic face's skin would come out of every face's in each sum, where none pushes.
    """
    bag = find_mouth_bag(space)
    if bag is None:
        return displacement
    result = displacement.copy()
    moved = push_inside(space, bag, require_depths(space, bag), space.points + displacement)
    result[bag.vertices] = moved - space.points[bag.vertices]
    return result[space.welded]
