"""Sculpt files: what a line means, and an error message for every invalid one."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from omote.interchange.formats.sculpt_toml import SculptFileError, parse_sculpt, read_sculpt
from omote.model.space.gain import Gain

TEXT = """
name = "a"
[look]
skin = "#112233"
[base]
old = 0.5
[points]
"nose"  = { at = [0, -36, 168], to = [0, -30, 200] } # the tip
"crown" = { at = [0, 121, 40] }
"cheek" = { at = [42, -40, 128], by = [5, 0.5, 0] }
"""


def test_a_line_says_where_a_point_is_and_where_it_goes() -> None:
    sculpt = parse_sculpt(TEXT)
    assert (sculpt.name, sculpt.symmetric, sculpt.kernel) == ("a", True, "triharmonic")
    assert sculpt.look.skin == "#112233"
    assert dict(sculpt.base) == {"old": 0.5}
    assert np.allclose(sculpt.points, [[0.0, -0.036, 0.168], [0.0, 0.121, 0.04], [0.042, -0.04, 0.128]])
    assert np.allclose(sculpt.moves, [[0.0, 0.006, 0.032], [0.0, 0.0, 0.0], [0.005, 0.0005, 0.0]])


def test_a_brush_says_where_the_skin_is_smoothed() -> None:
    (brush,) = parse_sculpt(TEXT + "[smooth]\near = { at = [79, -8, 42], reach = 40, rounds = 9 }").brushes
    assert np.allclose([*brush.at, brush.reach], [0.079, -0.008, 0.042, 0.04])
    assert brush.rounds == 9
    assert parse_sculpt(TEXT).brushes == ()


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("ear = 3", "brush 'ear' is 3; expected { at ="),
        ("ear = { at = [1, 2, 3], reach = 4 }", "expected { at = .*, reach = length, rounds = count }"),
        ("ear = { at = [1, 2], reach = 4, rounds = 2 }", "`at` of brush 'ear' is .*; expected three numbers"),
        ("ear = { at = [1, 2, 3], reach = 4, rounds = 0 }", "a brush goes 0 rounds"),
    ],
)
def test_a_brush_that_is_none_is_refused(line: str, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        parse_sculpt(f"{TEXT}[smooth]\n{line}")


def test_gains_say_how_strongly_the_face_answers_by_region_and_by_expression() -> None:
    gains = parse_sculpt(TEXT + "[gains]\nears = 1.5\nbrows = 2\nmouth = { all = 1.2, angry = 1.8 }").gains
    assert gains == (Gain("brows", 2.0), Gain("mouth", 1.2), Gain("mouth", 1.8, "angry"), Gain("ears", 1.5))
    assert parse_sculpt(TEXT).gains == ()


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("tail = 2", "a gain is of region 'tail'; expected one of brows"),
        ("mouth = 5", "the gain of mouth is 5; expected a number from 0"),
        ('mouth = "much"', "the gain of mouth is 'much'"),
        ('mouth = { "" = 1.5 }', "the expression of the gain of mouth is named ''"),
    ],
)
def test_a_gain_that_is_none_is_refused(line: str, sentence: str) -> None:
    with pytest.raises(ValueError, match=sentence):
        parse_sculpt(f"{TEXT}[gains]\n{line}")


def test_metres_may_be_asked_for() -> None:
    head = 'name = "a"\nunit = "m"\nkernel = "biharmonic"\nsymmetric = false\n'
    text = f"{head}[points]\na = {{at = [1, 2, 3], by = [1, 0, 0]}}"
    sculpt = parse_sculpt(text)
    assert (sculpt.kernel, sculpt.symmetric) == ("biharmonic", False)
    assert np.array_equal(sculpt.points, [[1.0, 2.0, 3.0]])
    assert np.array_equal(sculpt.moves, [[1.0, 0.0, 0.0]])


def test_a_ball_is_seven_points_that_grow_around_the_first() -> None:
    ball = "{ at = [30, 0, 120], to = [34, 8, 120], reach = 10, size = [1, 2, 1.5] }"
    sculpt = parse_sculpt(f'name = "a"\n[points]\neye = {ball}')
    there = sculpt.points + sculpt.moves
    assert np.allclose(sculpt.points[0], [0.03, 0.0, 0.12])
    assert np.allclose(there[0], [0.034, 0.008, 0.12])
    arms = sculpt.points[1:] - sculpt.points[0]
    assert np.allclose(np.linalg.norm(arms, axis=1), 0.01)
    assert np.allclose(np.abs(arms).sum(axis=0), 0.02)
    assert np.allclose(there[1:] - there[0], arms * [1.0, 2.0, 1.5])


def test_a_ball_on_the_midline_leaves_its_mirror_image_to_the_symmetry() -> None:
    text = 'name = "a"\n{}[points]\nnose = {{ at = [0, 0, 150], reach = 10, size = 2 }}'
    assert len(parse_sculpt(text.format("")).points) == 6
    assert len(parse_sculpt(text.format("symmetric = false\n")).points) == 7


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ('name = "a"', 'name = "a', "this is no TOML"),
        ('name = "a"', "", "a sculpt is named ''"),
        ('name = "a"', "name = 3", "a sculpt is named 3"),
        ('name = "a"', 'name = "a"\ncolour = 1', "a sculpt has 'colour'; expected only name, unit"),
        ('name = "a"', 'name = "a"\nunit = "inch"', "unit is 'inch'; expected one of 'mm', 'm'"),
        ('name = "a"', 'name = "a"\nunit = ["mm"]', r"unit is \['mm'\]; expected one of"),
        ('name = "a"', 'name = "a"\nkernel = "thin"', "kernel is 'thin'; expected one of 'biharmonic', 'triharmonic'"),
        ('name = "a"', 'name = "a"\nsymmetric = 1', "symmetric is 1; expected true or false"),
        ('skin = "#112233"', 'skin = "red"', "skin of a look is 'red'"),
        ('skin = "#112233"', "fur = 2", "fur of a look is 2; expected a number from 0 to 1"),
        ('skin = "#112233"', "coat = 1", "coat of a look is 1; expected a colour"),
        ('skin = "#112233"', 'wig = "#112233"', "the look has 'wig'; expected only skin, lip"),
        ("old = 0.5", "old = true", "base 'old' is True; expected a finite number"),
        ("old = 0.5", "old = inf", "base 'old' is inf; expected a finite number"),
        ("at = [0, 121, 40]", "to = [0, 121, 40]", r"point 'crown' is .*; expected \{ at"),
        ("{ at = [0, 121, 40] }", "7", r"point 'crown' is 7; expected \{ at"),
        ("at = [0, 121, 40]", "at = [0, 121]", r"`at` of point 'crown' is \[0, 121\]; expected three numbers"),
        ("at = [0, 121, 40]", 'at = [0, 121, "x"]', "`at` of point 'crown' is 'x'; expected a finite number"),
        ("at = [0, 121, 40]", "at = [0, nan, 40]", "`at` of point 'crown' is nan; expected a finite number"),
        ("to = [0, -30, 200]", "goes = [0, -30, 200]", "point 'nose' has 'goes'; expected only at, to"),
        ("to = [0, -30, 200]", "to = [0, 0, 0], by = [0, 0, 0]", "point 'nose' has both `to` and `by`"),
        ("to = [0, -30, 200]", "size = 2", "point 'nose' has a `size` without a `reach`"),
        ("to = [0, -30, 200]", "reach = 0", "point 'nose' has reach 0.0 and size 1; expected both above zero"),
        ("to = [0, -30, 200]", "reach = 9, size = -1", "point 'nose' has reach 9.0 and size -1"),
        ('"crown"', '"nose"', "this is no TOML"),
    ],
)
def test_every_other_text_is_refused_with_a_sentence(old: str, new: str, sentence: str) -> None:
    assert old in TEXT
    with pytest.raises(ValueError, match=sentence):
        parse_sculpt(TEXT.replace(old, new, 1))


def test_a_sculpt_without_points_is_refused() -> None:
    with pytest.raises(SculptFileError, match="has no control points"):
        parse_sculpt('name = "a"')
    with pytest.raises(SculptFileError, match=r"points is 3; expected a table \[points\]"):
        parse_sculpt('name = "a"\npoints = 3')


def test_a_refusal_names_the_file(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    with pytest.raises(SculptFileError, match=r"a\.toml cannot be read"):
        read_sculpt(path)
    path.write_bytes(b"\xff\xfe")
    with pytest.raises(SculptFileError, match=r"a\.toml cannot be read"):
        read_sculpt(path)
    path.write_text(TEXT.replace("[0, 121, 40]", "[0, 121]"), encoding="utf-8")
    with pytest.raises(SculptFileError, match=r"a\.toml: `at` of point 'crown'"):
        read_sculpt(path)
    path.write_text(TEXT, encoding="utf-8")
    assert read_sculpt(path).name == "a"
