"""New identities: the same for the same seed, whatever their number; others for another."""

from __future__ import annotations

import numpy as np
import pytest

import omote

CAST = omote.load_cast()


def test_a_face_depends_on_seed_and_number_alone() -> None:
    two = omote.add_random_faces(CAST, 2, seed=3)
    one = omote.add_random_faces(CAST, 1, seed=3)
    other = omote.add_random_faces(CAST, 1, seed=4)
    assert [*two.faces][len(CAST.faces) :] == ["random_3_001", "random_3_002"]
    first, second, again, strange = (
        cast.faces[name].positions
        for cast, name in ((two, "random_3_001"), (two, "random_3_002"), (one, "random_3_001"), (other, "random_4_001"))
    )
    assert np.array_equal(first, again)
    assert two.looks["random_3_001"] == one.looks["random_3_001"] != two.looks["random_3_002"]
    for else_ in (second, strange):
        assert np.linalg.norm(first - else_, axis=1).mean() > 0.001
    with pytest.raises(ValueError, match="0 random faces cannot be drawn; give 1 to 1000"):
        omote.add_random_faces(CAST, 0)
    with pytest.raises(ValueError, match="the seed is -1; give 0 or more"):
        omote.add_random_faces(CAST, 1, seed=-1)
    with pytest.raises(ValueError, match="has a face 'random_3_001' already; give another seed than 3"):
        omote.add_random_faces(one, 1, seed=3)
