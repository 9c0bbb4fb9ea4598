"""What was on air, as a curve."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.cast import Cast
from omote.perform.clips.cut_clip import cut_curve, record
from omote.perform.performer import Performer

DT = 1.0 / 60.0


def test_what_was_recorded_has_the_frames_between_two_times(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_gaze(0.1, 0.0)
    performer.call_expression("jawOpen", seconds=0.4)
    performer.call_expression("browInnerUp", seconds=0.4, region="mouth")
    shown = [(tick * DT, performer.advance(DT)) for tick in range(60)]
    curve = cut_curve(shown, cast, start=10 * DT, stop=20 * DT)
    assert curve.times == pytest.approx([place * DT for place in range(11)], abs=1e-12)
    assert not any(column.startswith("channel/eyeLook") for column in curve.layout.columns)
    column = {name: curve.table[:, place] for place, name in enumerate(curve.layout.columns)}
    assert column["brows/jawOpen"].tolist() == [frame.expressions["jawOpen"] for _, frame in shown[10:21]]
    assert column["mouth/browInnerUp"].tolist() == [frame.regions["mouth"]["browInnerUp"] for _, frame in shown[10:21]]
    with pytest.raises(ValueError, match="nothing was recorded between 8 s and 9 s"):
        cut_curve(shown, cast, start=8.0, stop=9.0)


def test_a_performer_is_recorded_from_where_it_is(cast: Cast) -> None:
    performer = Performer(cast)
    performer.set_channel("jawOpen", 0.5)
    curve = record(performer, cast, seconds=0.5, rate=30)
    assert curve.times == pytest.approx(np.arange(16) / 30)
    assert set(curve.table[:, curve.layout.columns.index("channel/jawOpen")]) == {0.5}
