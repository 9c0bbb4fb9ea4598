"""A cast as bytes less its base comes back as it was; keys change with what an export holds, and with nothing else."""

from dataclasses import replace

import numpy as np

from omote.model.cast import Cast, Look
from omote.model.space.expression import Title
from omote.server.farm.own_cast import key_of_face, key_of_options, pack_own, unpack_own
from omote.showfile.contents import pack_expression, unpack_expression
from tests.stage_data.heads import synthetic_cast


def own_cast() -> Cast:
    """The synthetic cast with a face and an expression of a show file."""
    cast = synthetic_cast()
    aunt = replace(cast.faces["broad"], name="aunt")
    return replace(
        cast,
        faces={**cast.faces, "aunt": aunt},
        looks={**cast.looks, "aunt": Look(skin="#102030")},
        expressions={**cast.expressions, "crooked": unpack_expression(pack_expression(cast.expressions["smile"]))},
        titles={**cast.titles, "crooked": Title("Crooked", "own", "lower")},
    )


def test_a_cast_comes_back_to_the_bit() -> None:
    cast = own_cast()
    found = unpack_own(synthetic_cast(), pack_own(cast, synthetic_cast()))
    assert found.digest == cast.digest
    np.testing.assert_array_equal(found.faces["aunt"].positions, cast.faces["aunt"].positions)
    assert found.titles["crooked"] == cast.titles["crooked"]


def test_only_what_is_own_is_sent() -> None:
    assert len(pack_own(synthetic_cast(), synthetic_cast())) < 10
    assert unpack_own(synthetic_cast(), pack_own(synthetic_cast(), synthetic_cast())).digest == synthetic_cast().digest


def test_a_key_says_head_expressions_options_face_and_look() -> None:
    cast = own_cast()
    shared = key_of_options(cast, ["smile", "jawOpen"], ("0.1", ".glb"))
    others = {
        key_of_options(cast, ["smile"], ("0.1", ".glb")),
        key_of_options(cast, ["jawOpen", "smile"], ("0.1", ".glb")),
        key_of_options(cast, ["smile", "jawOpen"], ("0.2", ".glb")),
        key_of_options(cast, ["smile", "jawOpen"], ("0.1", ".usdc")),
    }
    assert len({shared, *others}) == 5
    key = key_of_face(cast, "aunt", shared)
    painted = replace(cast, looks={**cast.looks, "aunt": Look(skin="#102031")})
    assert len({key, key_of_face(painted, "aunt", shared), key_of_face(cast, "broad", shared)}) == 3
    more = replace(cast, faces={**cast.faces, "uncle": replace(cast.faces["broad"], name="uncle")})
    assert key_of_face(more, "aunt", key_of_options(more, ["smile", "jawOpen"], ("0.1", ".glb"))) == key
