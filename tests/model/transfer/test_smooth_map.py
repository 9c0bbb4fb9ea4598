"""The smooth map: the source itself unchanged, lids closed as far as on the source, nothing folded, on every face."""

from __future__ import annotations

import numpy as np
import pytest

import omote
from omote.model.transfer import compound as compounds
from omote.model.transfer.compound import compound
from omote.model.transfer.smooth_map import Carrier, carried, folds

BLINKS = {"eyeBlinkLeft": 0, "eyeBlinkRight": 1}
UNITS = ("jawOpen", "mouthSmileLeft", "mouthFunnel", "mouthClose", "browInnerUp", "cheekPuff", *BLINKS)


@pytest.fixture(scope="module")
def carriers() -> dict[str, Carrier]:
    cast = omote.load_cast()
    return {name: compounds.carrier(cast.space, face) for name, face in cast.faces.items()}


def displacement(name: str) -> np.ndarray:
    cast = omote.load_cast()
    worn = compound(cast.space, cast.faces["generic"], cast.expressions[name])
    return worn.astype(np.float64) - cast.space.points


@pytest.mark.parametrize("unit", UNITS)
def test_the_source_face_wears_its_own_expression_unchanged(carriers: dict[str, Carrier], unit: str) -> None:
    moved = displacement(unit)
    assert np.abs(carried(carriers["generic"], moved) - carriers["generic"].positions - moved).max() < 1e-6


@pytest.mark.parametrize("unit", UNITS)
def test_no_triangle_folds_on_any_face(carriers: dict[str, Carrier], unit: str) -> None:
    moved = displacement(unit)
    for name, carrier in carriers.items():
        worn = carried(carrier, moved)
        assert folds(carrier, worn, carrier.generic + moved).sum() == 0, name


@pytest.mark.parametrize("unit", sorted(BLINKS))
def test_lids_close_on_every_face_as_far_as_on_the_source(carriers: dict[str, Carrier], unit: str) -> None:
    moved = displacement(unit)
    for name, carrier in carriers.items():
        contact = carrier.contacts[BLINKS[unit]]
        source = (contact.source * contact.line.rungs(carrier.generic + moved)).sum(axis=1)
        here = (contact.target * contact.line.rungs(carried(carrier, moved))).sum(axis=1)
        relative = here.sum() / contact.lengths.sum(), (contact.ratios * source).sum() / contact.lengths.sum()
        assert relative[0] == pytest.approx(relative[1], abs=0.05), name
        assert relative[1] < 0.1, "the source does not close"


def test_a_face_at_rest_stays_at_rest(carriers: dict[str, Carrier]) -> None:
    for carrier in carriers.values():
        assert np.abs(carried(carrier, np.zeros_like(carrier.generic)) - carrier.positions).max() < 1e-6


def test_far_from_lids_and_lips_a_displacement_is_added_as_it_is(carriers: dict[str, Carrier]) -> None:
    moved = displacement("eyeBlinkLeft")
    for carrier in carriers.values():
        worn = carried(carrier, moved)
        width = np.ptp(carrier.positions[carrier.contacts[0].line.loop, 0])
        loop = carrier.positions[carrier.contacts[0].line.loop].mean(axis=0)
        far = np.linalg.norm(carrier.positions - loop, axis=1) > 4 * width
        assert np.abs(worn - carrier.positions - moved)[far].max() < 1e-8
