"""Bodies: what is none is rejected, and what is kept cannot be changed."""

from __future__ import annotations

import numpy as np
import pytest

from omote.model.body.body import Body

AT = np.zeros((2, 3), np.float32)


def test_what_is_no_body_is_rejected_and_one_is_frozen() -> None:
    assert not Body("one", AT, AT, AT, AT).joints.flags.writeable
    for wrong in ({"size": 20.0}, {"joints": np.full((2, 3), np.nan)}, {"edge": np.zeros((2, 2))}, {"name": ""}):
        with pytest.raises(ValueError, match=r"size|joints|edge|name"):
            Body(**({"name": "one", "positions": AT, "edge": AT, "joints": AT, "ends": AT} | wrong))
