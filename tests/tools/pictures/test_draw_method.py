"""The figures of docs/method.md show what the page says of them."""

import re
import xml.etree.ElementTree as ET

import numpy as np
import pytest

import omote
from omote.model.cast import Cast
from omote.model.controls.default_net import default_net
from omote.model.controls.inverse_solve import CLOSE
from omote.model.controls.net_field import build_net_field
from tools.pictures.draw_method import FIGURES, PICTURES, main
from tools.pictures.method.mix import CALLS, RATE, played
from tools.pictures.method.smooth_map import FAR_FACE, LID, MOUTH, WEIGHTS, closures, stages, summed
from tools.pictures.method.solve import solving

PAGE = (PICTURES.parent / "method.md").read_text(encoding="utf-8")
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def cast() -> Cast:
    """The built-in cast."""
    return omote.load_cast()


def test_every_figure_is_stored_and_on_the_page() -> None:
    assert set(re.findall(r"\(pictures/method-(\w+)\.svg\)", PAGE)) == set(FIGURES)
    assert {path.stem.removeprefix("method-") for path in PICTURES.glob("method-*")} == set(FIGURES)


def test_all_figures_together_are_small() -> None:
    assert sum(path.stat().st_size for path in PICTURES.glob("method-*")) < 1_500_000


def test_a_figure_that_nobody_knows_is_rejected(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["spase"]) == 2
    assert "'spase'" in capsys.readouterr().err


@pytest.mark.parametrize("expression", [LID, MOUTH])
def test_the_stages_begin_with_folds_and_end_without(cast: Cast, expression: str) -> None:
    found = stages(cast, cast.faces[FAR_FACE], expression)
    assert found[0].name == "the paper's map"
    assert found[0].folded.sum() > 10
    assert not found[-1].folded.any()
    compound = omote.compound(cast.space, cast.faces[FAR_FACE], cast.expressions[expression])
    np.testing.assert_array_equal(found[-1].skin.astype(np.float32), compound)


def test_the_figure_of_stages_says_how_many_folds_each_has(cast: Cast) -> None:
    figure = ET.fromstring(FIGURES["stages"](cast).svg())
    assert len(figure.findall(f"{SVG}image")) == 12
    words = [text.text or "" for text in figure.findall(f"{SVG}text")]
    shown = [int(word.split()[0]) for word in words if re.fullmatch(r"\d+ folds?", word)]
    every = [(stage.name, int(stage.folded.sum())) for name in (LID, MOUTH)
             for stage in stages(cast, cast.faces[FAR_FACE], name)]  # fmt: skip
    assert len(shown) == 10
    assert set(shown) <= {count for _, count in every}
    assert len(figure.findall(f"{SVG}polygon")) <= sum(shown)


def test_lids_close_as_on_the_source_and_not_by_added_deltas(cast: Cast) -> None:
    line = next(line for line in cast.space.lines if line.name == "lid_left")
    found = {face: closures(cast, face, "eyeBlinkLeft", line) for face in ("doll", "dog")}
    for curves in found.values():
        assert len(curves["ours"]) == len(WEIGHTS)
        assert np.abs(np.subtract(curves["ours"], curves["source"])).max() < 0.05
    assert abs(found["doll"]["added deltas"][-1] - found["doll"]["source"][-1]) > 0.3


def test_the_sum_folds_and_its_correctives_mend_it(cast: Cast) -> None:
    *_, added, corrected = summed(cast)
    assert added.folded.any()
    assert not corrected.folded.any()


def test_a_frozen_call_stops_dead_and_an_inertial_one_does_not() -> None:
    frozen = played(inertial=False)
    ours = played(inertial=True)
    np.testing.assert_allclose(ours.weights.sum(axis=1), 1.0, atol=1e-12)
    for time, _, _ in CALLS[1:]:
        step = int(np.ceil(time * RATE))
        assert frozen.speed[step - 1] > 0.5
        assert frozen.speed[step] == 0.0
        assert ours.speed[step] == pytest.approx(ours.speed[step - 1], rel=0.1)


def test_the_solve_comes_to_its_target(cast: Cast) -> None:
    net_field = build_net_field(cast.space, default_net(cast.space))
    misses = solving(cast, "dog", 0, net_field, np.array([[0.0, 0.004, 0.0]]))
    assert misses[0] == pytest.approx(0.004)
    assert misses[-1] <= CLOSE


def test_the_same_figure_has_the_same_bytes(cast: Cast) -> None:
    for name in ("transfer", "calls"):
        assert FIGURES[name](cast).svg() == FIGURES[name](cast).svg()
