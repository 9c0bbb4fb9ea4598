"""Faces and expressions by what people read of them: a name wins over a label."""

from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

import pytest

from omote.model.space.expression import Title
from omote.perform.called_names import find_called

FACES: Mapping[str, str] = {"cousin": "My Cousin", "aunt": "Cousin"}
TITLES: Mapping[str, Title] = {
    "smile": Title("Smile"),
    "on_air_1": Title("Grin"),
    "on_air_2": Title("Wry"),
    "b": Title("Wry"),
}
CAST: Any = SimpleNamespace(faces=FACES, face_labels=FACES, expressions=TITLES, titles=TITLES)


@pytest.mark.parametrize(
    ("typed", "kind", "name"),
    [
        ("on_air_1", "expression", "on_air_1"),
        ("Grin", "expression", "on_air_1"),
        ("grin", "channel", "on_air_1"),
        ("my-cousin", "face", "cousin"),
        ("Cousin", "face", "cousin"),
    ],
)
def test_a_name_is_found_and_else_a_label(typed: str, kind: str, name: str) -> None:
    assert find_called(typed, kind, CAST) == name


def test_what_is_called_by_no_name_or_by_several_is_refused() -> None:
    with pytest.raises(ValueError, match="the expression 'Wry' could be on_air_2 or b"):
        find_called("Wry", "expression", CAST)
    with pytest.raises(ValueError, match="there is no face 'Grin'"):
        find_called("Grin", "face", CAST)
