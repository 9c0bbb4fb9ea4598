"""A clip that is cut from a recording is what showed, to the precision of what is kept."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from omote.perform.clips.cut_clip import cut_curve
from omote.server.recording.recorded_clip import keep_clip
from omote.server.recording.recorded_show import RecordedShow, Span
from omote.show.objects.clips import StoredClip, read_clips
from omote.showfile.recording_file import open_recording, recording_path
from omote.showfile.show_file import open_show
from tests import synthetic
from tests.server.recording.test_recorded_show import record

CAST = synthetic.cast()


def test_what_was_recorded_becomes_a_clip_and_lanes_of_it(tmp_path: Path) -> None:
    file = tmp_path / "a.omote"
    open_show(file).close()
    record(recording_path(file), 21, 3.0)
    recorded = open_recording(recording_path(file))
    show = RecordedShow(recorded, CAST)
    whole = show.find_span()
    span = Span(whole.start, whole.first + 0.5, whole.first + 1.5)
    made = keep_clip(file, show, span, "one", "line", lane="first")
    assert made.seconds == pytest.approx(1.0, abs=0.35)  # a late tick of the show that was recorded
    again = keep_clip(file, show, span, "one", "line", parts=["mouth"], lane="mouth")
    assert [(lane.name, lane.parts) for lane in again.lanes][-1] == ("mouth", ("mouth",))
    with pytest.raises(ValueError, match="nobody"):
        keep_clip(file, show, span, "nobody", "other")
    opened = open_show(file)
    clips, lost = read_clips(opened.stored().documents[StoredClip.kind])
    opened.close()
    assert (list(clips), lost) == (["line"], [])
    shown = [(tick.state.time, tick.state.characters["one"]) for tick in show.replay(span)]
    exact = cut_curve(shown, CAST, start=shown[0][0], stop=shown[-1][0])
    kept = clips["line"].lanes[0].curve
    assert np.allclose(kept.times, exact.times, atol=1e-6)
    assert np.allclose(kept.table, exact.table, atol=2**-23)
    show.close()
    recorded.close()
