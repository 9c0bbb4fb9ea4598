"""The masks of the play regions as stages get them."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from omote.builtin import load_cast
from omote.model.known_names import PLAY_REGIONS
from omote.model.space.parameter_space import ParameterSpace
from omote.perform.blending.region_masks import play_masks
from omote.stage_data.assets import first_rows, rest_positions
from omote.stage_data.region_document import ONE, region_document


def masks_in(data: bytes) -> NDArray[np.float64]:
    """The masks of a document, (n, 4), one is all."""
    return np.frombuffer(data, "<u2").reshape(-1, len(PLAY_REGIONS)) / ONE


def test_the_document_holds_the_masks_of_skin_parts_and_allowances() -> None:
    cast = load_cast()
    document = region_document(cast.space)
    assert document is not None
    rows = masks_in(document.rows)
    allowances = masks_in(document.allowances)
    assert len(rows) == len(rest_positions(cast, cast.faces["generic"]))
    starts = first_rows(cast)
    for column, region in enumerate(PLAY_REGIONS):
        mask = play_masks(cast.space)[region]
        for name, own in {"skin": mask.skin, **mask.parts}.items():
            sent = rows[starts[name] : starts[name] + len(own), column]
            np.testing.assert_allclose(sent, own[:, 0], rtol=0, atol=0.51 / ONE)
        np.testing.assert_allclose(allowances[:, column], mask.allowances, rtol=0, atol=0.51 / ONE)
    for masks in (rows, allowances):
        np.testing.assert_allclose(masks.sum(axis=1), 1.0, rtol=0, atol=2.0 / ONE)


def test_a_head_without_two_eyeballs_has_no_regions() -> None:
    space: ParameterSpace = load_cast().space
    blind = replace(space, parts={name: part for name, part in space.parts.items() if part.eye != "left"})
    assert region_document(blind) is None
