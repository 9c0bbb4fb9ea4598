"""A frame of a source is checked, and covers the parts in which its channels act."""

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.model.space.expression import Title
from omote.perform.frame import Gaze, Head
from omote.perform.layers.columns import make_columns
from omote.perform.layers.layer_names import LAYER_PARTS
from omote.perform.layers.source_frame import (
    Driver,
    SourceFrame,
    check_frame,
    check_names,
    fits,
    parts_of,
    source_frame,
)


def test_it_covers_the_parts_of_its_channels_as_far_as_it_may(cast: Cast) -> None:
    titles = {**cast.titles, "jawOpen": Title("jaw", region="jaw"), "browInnerUp": Title("brows", region="brows")}
    columns = make_columns(_titled(cast, titles), ("jawOpen", "browInnerUp", "smile"))
    assert parts_of(Driver("a", ("jawOpen",)), columns) == ("mouth",)
    assert parts_of(Driver("a", ("jawOpen", "browInnerUp"), head=True), columns) == ("brows", "mouth", "head")
    assert parts_of(Driver("a", ("smile",)), columns) == ("brows", "eyes", "mouth", "rest")
    assert parts_of(Driver("a", ("smile",), parts=("mouth", "gaze")), columns) == ("mouth",)
    assert parts_of(Driver("a", (), gaze=True), columns) == ("gaze",)


def _titled(cast: Cast, titles: dict[str, Title]) -> Cast:
    found = cast.with_expressions()
    object.__setattr__(found, "titles", titles)
    return found


def test_what_drives_a_layer_is_the_same_while_it_sends_the_same_channels() -> None:
    frame = SourceFrame(("jawOpen",), np.zeros(1), head=Head(), source="phone")
    driver = Driver("phone", ("jawOpen",), head=True)
    assert fits(driver, frame)
    for other in (
        Driver("tablet", ("jawOpen",), head=True),
        Driver("phone", ("smile",), head=True),
        Driver("phone", ("jawOpen",)),
        Driver("phone", ("jawOpen",), head=True, gaze=True),
        Driver("phone", ("jawOpen",), head=True, parts=LAYER_PARTS[:2]),
    ):
        assert not fits(other, frame)


def test_what_cannot_be_driven_is_refused_by_name(cast: Cast) -> None:
    with pytest.raises(ValueError, match=r"there is no channel 'jawopen' in this cast; near are jawOpen"):
        check_names(["jawopen"], cast.expressions)
    with pytest.raises(ValueError, match=r"there is no channel 'neutral'"):
        check_names(["neutral"], cast.expressions)
    with pytest.raises(ValueError, match=r"names a channel twice"):
        check_names(["smile", "smile"], cast.expressions)
    with pytest.raises(ValueError, match=r"the channel smile is 2.0; give a number from -0.5 to 1.5"):
        source_frame(cast.expressions, {"smile": 2.0}, None, None)
    with pytest.raises(ValueError, match=r"the gaze's yaw \(radians; 40 degrees at most\) is 1.0"):
        source_frame(cast.expressions, {}, None, (1.0, 0.0))
    with pytest.raises(ValueError, match=r"smile of the layer tracker is no number \(NaN\)"):
        check_frame(SourceFrame(("smile",), np.array([np.nan])), "tracker")
    with pytest.raises(ValueError, match=r"2 values came for 1 channels; send one for each"):
        check_frame(SourceFrame(("smile",), np.zeros(2), gaze=Gaze()), "tracker")


@pytest.mark.parametrize(
    "given", [(0.1, 0.2), (0.1, 0.2, 0.3, 0.4), (), 0.1, "abc"], ids=["two", "four", "none", "one", "text"]
)
def test_a_head_has_three_angles_and_a_gaze_two(cast: Cast, given: object) -> None:
    with pytest.raises(ValueError, match=r"the head is .* give yaw, pitch, roll, radians"):
        source_frame(cast.expressions, {}, given, None)  # type: ignore[arg-type]
    if given != (0.1, 0.2):
        with pytest.raises(ValueError, match=r"the gaze is .* give yaw, pitch, radians"):
            source_frame(cast.expressions, {}, None, given)  # type: ignore[arg-type]


def test_weights_come_by_name(cast: Cast) -> None:
    with pytest.raises(TypeError, match="the channels are a list; give weights by name"):
        source_frame(cast.expressions, [0.1], None, None)  # type: ignore[arg-type]


def test_angles_may_come_as_an_array(cast: Cast) -> None:
    frame = source_frame(cast.expressions, {}, np.array([0.1, 0.2, 0.0]), None)  # type: ignore[arg-type]
    assert frame.head == Head(0.1, 0.2, 0.0)
