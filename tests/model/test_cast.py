"""The cast: a whole of faces and expressions on one space."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.cast import Cast, Look
from omote.model.extract import extract
from omote.model.face import Face
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
    face, smile = cast().faces["generic"], cast().expressions["smile"]
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


@pytest.mark.parametrize("colour", ["red", "#12345", "#12345g", 7])
def test_looks_are_refused(colour: object) -> None:
    with pytest.raises(ValueError, match=r"lip of a look is .*expected a colour"):
        Look(lip=colour)  # type: ignore[arg-type]
