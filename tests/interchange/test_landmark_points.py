"""Landmarks as people give them."""

import pytest

from omote.interchange.landmark_points import explain_landmarks, parse_document, parse_point, require_enough
from omote.model.fitting.landmarks import SEVEN


def test_a_word_names_a_point() -> None:
    assert parse_point("nose_tip=0,-1.25,9e1") == ("nose_tip", (0.0, -1.25, 90.0))
    for word in ("nose=0,1,2", "nose", ""):
        with pytest.raises(ValueError, match="is no landmark; expected one of left_eye_outer"):
            parse_point(word)
    for word in ("nose_tip", "nose_tip=1,2", "nose_tip=1,2,x", "nose_tip=1,2,nan", "nose_tip=1;2;3"):
        with pytest.raises(ValueError, match="says no place; expected three numbers with commas"):
            parse_point(word)


def test_a_document_is_of_one_scan_or_of_several_by_their_names() -> None:
    plain = b'{"nose_tip": [0, 1, 2], "mouth_left": [3, 4, 5]}'
    points = {"nose_tip": (0.0, 1.0, 2.0), "mouth_left": (3.0, 4.0, 5.0)}
    assert parse_document(plain, "a.ply") == points
    several = b'{"a.ply": ' + plain + b', "b.ply": {"nose_tip": [9, 9, 9]}}'
    assert parse_document(several, "a.ply") == points
    assert parse_document(several, "b.ply") == {"nose_tip": (9.0, 9.0, 9.0)}
    with pytest.raises(ValueError, match=r"the landmarks have none for c\.ply; they name a\.ply, b\.ply"):
        parse_document(several, "c.ply")
    assert parse_document(several, "c.ply", others=["b.ply"]) == {}


@pytest.mark.parametrize("data", [b"", b"[]", b'{"nose_tip": "here"}', b'{"nose_tip": [1, 2]}', b'{"nose": [1, 2, 3]}'])
def test_other_documents_are_refused(data: bytes) -> None:
    with pytest.raises(ValueError, match=r"no JSON such as|is no landmark|says no place"):
        parse_document(data, "a.ply")


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('{\n  "nose_tip": [1, 2,],\n}', "line 2, column 21: trailing comma"),
        ('{"\u00fc": [1, 2, 3],\n"b": [1; 2]}', "line 2, column 8: "),
        ('{"nose_tip": [1, 2\n', "line 2, column 1: it ends too soon"),
    ],
)
def test_broken_json_is_shown_by_line_and_column(text: str, place: str) -> None:
    with pytest.raises(ValueError, match=place):
        parse_document(text.encode(), "a.ply")


def test_fewer_than_three_say_nothing() -> None:
    require_enough({})
    require_enough(dict.fromkeys(SEVEN[:3]))
    with pytest.raises(ValueError, match="2 landmarks are given; expected at least 3 of left_eye_outer"):
        require_enough(dict.fromkeys(SEVEN[:2]))
    assert all(name in explain_landmarks() for name in SEVEN)
