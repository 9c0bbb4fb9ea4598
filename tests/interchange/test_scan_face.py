"""The look of a fitted face has the scan's colours, where it has any."""

from dataclasses import replace

import numpy as np
import pytest

from omote.builtin import load_cast, load_mask, load_meshes
from omote.interchange.formats.png import read_png
from omote.interchange.scan_face import suggest_scan_look
from omote.interchange.skin_texture import Canvas, build_canvas
from omote.model.appearance.look_suggestion import wear_hair
from omote.model.cast import Look
from omote.model.fitting.fit_face import Fit
from omote.model.fitting.scan import Scan
from omote.model.space.face import Face
from omote.model.space.similarity import Similarity

CAST = load_cast()
MAN = CAST.faces["man"]
POINTS = MAN.positions.astype(np.float64)
STILL = Similarity(1.0, np.eye(3), np.zeros(3))
GREEN = (20, 160, 60)


@pytest.fixture(scope="module")
def canvas() -> Canvas:
    """The built-in skin's."""
    return build_canvas(read_png(load_mask()), load_meshes()[0], CAST.space.points)


def test_a_green_scan_makes_a_green_skin(canvas: Canvas) -> None:
    colours = np.tile(np.array(GREEN, np.uint8), (len(POINTS), 1))
    scan = Scan(POINTS, CAST.space.triangles, colours)
    kept = replace(CAST, looks={**CAST.looks, "man": Look(hair_style="bun", freckles=0.5)})
    look, notes = suggest_scan_look(kept, canvas, fitted(MAN, "man"), scan)
    assert notes == []
    assert look.albedo is not None
    covered = look.albedo.pixels[look.albedo.pixels[..., 3] == 255][:, :3].astype(int)
    assert np.abs(np.median(covered, axis=0) - GREEN).max() <= 3
    skin = [int(look.skin[at : at + 2], 16) for at in (1, 3, 5)]
    assert skin[1] > 2 * max(skin[0], skin[2])
    assert (look.hair_style, look.freckles) == ("", 0.0), "its scalp is green too, so no hair is seen"


def fitted(face: Face, kind: str = "people") -> Fit:
    """A fit that lies where its scan is."""
    nothing = np.zeros(len(face.positions))
    return Fit(face, nothing, nothing, STILL, (), kind)


def test_an_animal_without_colours_has_the_fur_of_that_from_which_it_began(canvas: Canvas) -> None:
    plain = Scan(POINTS, CAST.space.triangles)
    assert suggest_scan_look(CAST, canvas, fitted(MAN, "dog"), plain) == (CAST.looks["dog"], [])
    assert suggest_scan_look(CAST, canvas, fitted(MAN), plain) == (Look(hair_style="short"), [])


def test_a_scan_without_colours_and_a_cast_without_a_texture_leave_the_look(canvas: Canvas) -> None:
    first = CAST.looks["man"]
    plain = Scan(POINTS, CAST.space.triangles)
    assert suggest_scan_look(CAST, canvas, fitted(MAN, "man"), plain) == (first, [])
    coloured = replace(plain, colours=np.full((len(POINTS), 3), 9, np.uint8))
    assert suggest_scan_look(replace(CAST, atlas=None), canvas, fitted(MAN, "man"), coloured) == (first, [])


def test_a_bald_scan_has_no_shade_of_hair_on_its_scalp_until_hair_is_chosen(canvas: Canvas) -> None:
    scan = Scan(POINTS, CAST.space.triangles, np.tile(np.array(GREEN, np.uint8), (len(POINTS), 1)))
    bald, _ = suggest_scan_look(CAST, canvas, fitted(MAN), scan)
    assert (bald.hair_style, bald.scalp) == ("", 0.0)
    assert wear_hair(bald, "bob").scalp == Look().scalp
    assert wear_hair(Look(hair_style="bob"), "").scalp == 0.0


def test_colours_that_lie_nowhere_on_the_face_are_not_taken_over_and_that_is_said(canvas: Canvas) -> None:
    far = Scan(POINTS + np.array([5.0, 0.0, 0.0]), CAST.space.triangles, np.full((len(POINTS), 3), 9, np.uint8))
    look, (note,) = suggest_scan_look(CAST, canvas, fitted(MAN), far)
    assert look == Look(hair_style="short")
    assert note.startswith("its colours were not taken over: nothing of this scan lies near the face")
