"""What is sure is carried as it is; what is not goes with what is around it."""

import numpy as np

import omote
from omote.model.fitting.scan_correspondence import Correspondence
from omote.model.fitting.take_expressions import carry_skin

SPACE = omote.load_cast().space
ROWS = np.arange(SPACE.vertex_count)


def test_doubtful_places_follow_their_neighbours() -> None:
    sure = SPACE.on_sheet.astype(np.float64)
    lost = np.linalg.norm(SPACE.points - SPACE.points[SPACE.points[:, 2].argmax()], axis=1) < 0.01
    sure[lost] = 0.0
    moves = np.tile([0.0, 0.01, 0.0], (SPACE.vertex_count, 1))
    moves[lost] = [1.0, 1.0, 1.0]
    found = Correspondence(np.repeat(ROWS[:, None], 3, axis=1), np.full((len(ROWS), 3), 1.0 / 3.0), sure)
    (carried,) = carry_skin(SPACE, SPACE.points, found, [moves])
    np.testing.assert_allclose(carried[SPACE.on_sheet], np.tile([0.0, 0.01, 0.0], (SPACE.on_sheet.sum(), 1)), atol=1e-4)
