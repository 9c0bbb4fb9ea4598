"""The correctives' documents for stages."""

import numpy as np

from omote.builtin import load_cast
from omote.model.cast import Cast
from omote.model.transfer.compound import compound
from omote.model.transfer.corrective_regions import find_corrective_regions
from omote.perform.blending.compound_cache import compound_cache
from omote.perform.blending.correctives import FLOOR, ROUNDS
from omote.stage_data.assets import first_rows
from omote.stage_data.correctives_document import allowance_document, ball_radii, correctives_document
from tests.synthetic import FACES


def test_a_cast_without_lines_has_none(cast: Cast) -> None:
    assert correctives_document(cast, first_rows(cast)) is None
    face = cast.faces[FACES[0]]
    assert allowance_document(cast.space, face, cast.expressions["neutral"], face.positions) is None
    assert ball_radii(cast.space, face) == (0.0, 0.0)


def test_the_document_holds_corrective_regions() -> None:
    cast = load_cast()
    regions = find_corrective_regions(cast.space)
    document = correctives_document(cast, first_rows(cast))
    assert regions is not None
    assert document is not None
    assert (document.rounds, document.floor) == (list(ROUNDS), FLOOR)
    rows = np.frombuffer(document.rows, "<u4")
    assert np.array_equal(rows, regions.rows)
    assert np.array_equal(np.frombuffer(document.triangles, "<u4").reshape(-1, 3), regions.triangles)
    patches = regions.patches
    assert np.array_equal(np.frombuffer(document.patch_triangles, "<u4"), patches.triangles)
    assert np.array_equal(np.frombuffer(document.patch_ends, "<u4"), patches.ends)
    assert np.array_equal(np.frombuffer(document.row_patches, "<u4").reshape(len(rows), -1), patches.members)
    assert np.array_equal(np.frombuffer(document.row_shares, "<f4").reshape(len(rows), -1), patches.shares)
    for sent, own in zip(document.crossings, regions.crossings, strict=True):
        assert sent.upward == (own.kind == "lips")
        assert np.array_equal(np.frombuffer(sent.vertices, "<u4").reshape(-1, 4), own.vertices)
        assert np.array_equal(np.frombuffer(sent.side, "<f4"), own.side.astype(np.float32))


def test_followers_are_inner_skin_and_lashes_and_hang_on_rows() -> None:
    cast = load_cast()
    starts = first_rows(cast)
    document = correctives_document(cast, first_rows(cast))
    regions = find_corrective_regions(cast.space)
    assert document is not None
    assert regions is not None
    followers = np.frombuffer(document.followers, "<u4")
    anchors = np.frombuffer(document.anchors, "<u4").reshape(len(followers), -1)
    weights = np.frombuffer(document.weights, "<f4").reshape(anchors.shape)
    lashes = followers >= starts["lashes"]
    assert np.array_equal(followers[~lashes], regions.followers)
    part = cast.space.parts["lashes"]
    # Every lash of the built-in head lies within reach of the lids: it moves as its own anchors do.
    field = np.zeros(cast.space.vertex_count)
    field[regions.rows] = np.arange(len(regions.rows)) + 1.0
    here = (weights * (anchors + 1.0)).sum(axis=1)[lashes]
    assert np.allclose(here, (part.weights * field[part.anchors]).sum(axis=1), rtol=1e-5)


def test_an_allowance_is_the_engines_own() -> None:
    cast = load_cast()
    face = cast.faces["kaori"]
    skin = compound(cast.space, face, cast.expressions["eyeBlinkLeft"])
    document = allowance_document(cast.space, face, cast.expressions["eyeBlinkLeft"], skin)
    regions = find_corrective_regions(cast.space)
    assert document is not None
    assert regions is not None
    allowed = np.zeros(regions.size, np.float32)
    allowed[np.frombuffer(document.places, "<u4")] = np.frombuffer(document.values, "<f4")
    assert np.array_equal(allowed, compound_cache(cast).allowance("kaori", "eyeBlinkLeft"))
