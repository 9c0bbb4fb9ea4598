"""A shape that starts from another face than it is said to is recognised; expressions never are taken for one."""

import numpy as np
import pytest

from omote.builtin import load_cast
from omote.interchange.import_meshes import check_start, find_start
from omote.model.transfer.compound import compound

CAST = load_cast()
FACES = [*CAST.faces]
EXPRESSIONS = [*CAST.expressions]
STRONGEST = ("pain", "cry", "laugh", "shout")
"""Those that move the most of a head."""


@pytest.mark.parametrize("name", FACES)
def test_a_shape_starts_from_its_own_face_and_from_no_other(name: str) -> None:
    at = FACES.index(name)
    face = CAST.faces[name]
    for expression in (EXPRESSIONS[at * len(EXPRESSIONS) // len(FACES)], STRONGEST[at % len(STRONGEST)]):
        skin = compound(CAST.space, face, CAST.expressions[expression]).astype(np.float64)
        check_start(CAST, expression, skin, face, named=True)
        assert find_start(CAST, skin) == name
        for other in CAST.faces.values():
            if other is not face:
                with pytest.raises(ValueError, match=f"starts from {name!r} and not from {other.name!r}"):
                    check_start(CAST, expression, skin, other, named=True)


@pytest.mark.parametrize("seed", range(8))
def test_what_moves_a_whole_head_is_never_another_face(seed: int) -> None:
    random = np.random.default_rng(seed)
    face = CAST.faces[FACES[random.integers(len(FACES))]]
    waves = random.normal(scale=20.0, size=(3, 6))
    phases = random.uniform(0.0, 6.3, 6)
    moved = np.sin(CAST.space.points @ waves + phases) @ random.normal(scale=random.uniform(0.0005, 0.01), size=(6, 3))
    skin = face.positions + moved
    check_start(CAST, "wave", skin, face, named=False, own_rest=True)
    assert find_start(CAST, skin) == ""
    with pytest.raises(ValueError, match=f"'wave' does not start from {face.name!r}: .* a shape named 'neutral'"):
        check_start(CAST, "wave", skin, face, named=True)


def test_rounding_is_no_other_face() -> None:
    face = CAST.faces["man"]
    rounded = face.positions + np.random.default_rng(0).uniform(-5e-5, 5e-5, face.positions.shape)
    check_start(CAST, "smile", rounded, face, named=True)
