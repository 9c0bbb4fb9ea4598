"""What should be looked at in a fit, in sentences."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from omote.model.fitting.doubt import EYES, Doubt
from omote.model.fitting.shape.head_zones import HeadZones
from omote.model.fitting.shape.mode_fit import ModeFit

Values = NDArray[np.float64]

# Of the face, so much has to be seen, and half of that has to lie within so many millimetres.
LEAST_SEEN, NEAR = 0.6, 0.5
# A head farther than so many standard deviations from people, in the mean of the modes, is no person's.
STRANGE = 2.5


def find_doubts(
    zones: HeadZones, found: ModeFit, residual: Values, folds: int, filled: bool, turned: bool, /
) -> tuple[Doubt, ...]:  # fmt: skip
    """Sentences on a fit, none where it is sure.

    residual (V,): millimetres, nan where nothing was seen; folds: how many triangles are folded; filled: whether the
    scan is closed between its lids and nobody said what that means; turned: whether its triangles face inward.
    """
    face = residual[zones.face]
    seen, doubts = np.isfinite(face), list[Doubt]()
    if seen.mean() < LEAST_SEEN:
        doubts.append(Doubt(f"Only {seen.mean():.0%} of the face was seen; the rest is made up."))
    if seen.any() and np.median(face[seen]) > NEAR:
        far = f"{np.median(face[seen]):.1f} mm"
        doubts.append(Doubt(f"The face lies {far} from the scan; it may be noisy, or wrongly placed."))
    strange = float(np.sqrt((found.weights**2).mean()))
    if strange > STRANGE:
        doubts.append(Doubt("The head is unlike those of people; look whether eyes, nose and mouth are in place."))
    if folds:
        places = "one triangle" if folds == 1 else f"{folds} triangles"
        why = "points that were given may be off, or the scan is rough"
        doubts.append(Doubt(f"The skin stays folded at {places}: {why}."))
    if filled:
        asked = "The scan is closed between its lids, so they were opened; say whether its eyes are shut."
        doubts.append(Doubt(asked, EYES))
    if turned:
        doubts.append(Doubt("The scan is inside out, so it may be mirrored; look whether its left is its left."))
    return tuple(doubts)
