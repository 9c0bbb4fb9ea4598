"""The cast: a whole of faces and expressions on one space."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from omote.model.cast import TRAITS, Cast, Look
from omote.model.extraction.extract import extract
from omote.model.space.face import Face
from tests.synthetic import cast, head, space


def test_a_cast_with_more_is_a_new_one_and_has_another_digest() -> None:
    old = cast()
    new = old.with_faces(Face("wide", space().points * [1.2, 1, 1])).with_expressions(again=old.expressions["smile"])
    assert set(new.faces) - set(old.faces) == {"wide"}
    assert set(new.expressions) - set(old.expressions) == {"again"}
    assert "wide" not in old.faces
    assert len({old.digest, new.digest, old.with_expressions(again=old.expressions["smile"]).digest}) == 3


def test_the_same_content_has_the_same_digest() -> None:
    assert cast().with_faces(*cast().faces.values()).digest == cast().digest


def test_what_is_read_cannot_be_changed() -> None:
    with pytest.raises(TypeError):
        cast().faces["new"] = cast().faces["generic"]  # type: ignore[index]


def test_casts_are_refused() -> None:
    face = cast().faces["generic"]
    smile = cast().expressions["smile"]
    with pytest.raises(ValueError, match="no expression 'neutral'"):
        Cast(space(), {"generic": face}, {"smile": smile})
    with pytest.raises(ValueError, match=r"the face under 'other' is named 'generic'"):
        Cast(space(), {"other": face}, dict(cast().expressions))
    with pytest.raises(ValueError, match="has 5 vertices"):
        cast().with_faces(Face("small", np.zeros((5, 3))))
    other = type(space()).build(*head(), radius="surface")
    foreign = extract(other, face, np.zeros_like(space().points))
    with pytest.raises(ValueError, match="different rules do not mix"):
        cast().with_expressions(foreign=foreign)
    with pytest.raises(TypeError, match=r"the face is a ndarray; expected an omote.Face"):
        cast().with_faces(space().points)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"the expression is a str; expected an omote.Expression"):
        cast().with_expressions(smile="smile")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="an expression is named ''; expected a text of 1 to 80"):
        cast().with_expressions(**{"": smile})
    with pytest.raises(ValueError, match="there is a look for 'nobody'; expected one of"):
        cast().with_faces(looks={"nobody": Look()})
    with pytest.raises(TypeError, match="the look of 'generic' is a str; expected a Look"):
        cast().with_faces(looks={"generic": "red"})  # type: ignore[dict-item]


def test_the_generic_face_and_the_field_at_rest_cannot_be_others() -> None:
    with pytest.raises(ValueError, match=r"face 'generic' is not the face the space was built from.*another name"):
        cast().with_faces(Face("generic", space().points * [1.2, 1, 1]))
    with pytest.raises(ValueError, match=r"expression 'neutral' moves something.*another name"):
        cast().with_expressions(neutral=cast().expressions["smile"])


def test_the_pupil_of_an_expression_belongs_to_the_digest() -> None:
    wide = replace(cast().expressions["smile"], pupil=0.5)
    assert cast().with_expressions(smile=wide).digest != cast().digest
    with pytest.raises(ValueError, match="expression 'neutral' moves something"):
        cast().with_expressions(neutral=replace(cast().expressions["neutral"], pupil=0.5))


@pytest.mark.parametrize("name", TRAITS)
def test_every_trait_reaches_its_ends_and_no_further(name: str) -> None:
    low, high = TRAITS[name]
    for end in (low, high):
        assert getattr(Look(**{name: end}), name) == end  # type: ignore[arg-type]
    for beyond in (low - 0.01, high + 0.01):
        with pytest.raises(ValueError, match=f"{name} of a look is .*; expected a number from {low:g} to {high:g}"):
            Look(**{name: beyond})  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "trait", [{"slit": 1.2}, {"slit": True}, {"iris_size": 0.2}, {"lashes": "many"}, {"lashes": float("nan")}]
)
def test_traits_are_refused(trait: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=r"of a look is .*; expected a number from 0"):
        Look(**trait)  # type: ignore[arg-type]


@pytest.mark.parametrize("colour", ["red", "#12345", "#12345g", 7])
def test_looks_are_refused(colour: object) -> None:
    with pytest.raises(ValueError, match=r"lip of a look is .*expected a colour"):
        Look(lip=colour)  # type: ignore[arg-type]


def test_it_says_how_much_is_in_it(cast: Cast) -> None:
    assert repr(cast) == f"<cast of {len(cast.faces)} faces and {len(cast.expressions)} expressions>"
