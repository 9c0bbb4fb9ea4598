"""Picture files: which names they may have."""

from pathlib import Path

import pytest

from omote.interchange.formats.picture_names import KINDS, picture_kind


def test_the_name_says_the_kind() -> None:
    assert {picture_kind(Path(f"a{suffix}")) for suffix in KINDS} == set(KINDS.values())
    assert picture_kind(Path("A.PNG")) == "image/png"
    with pytest.raises(ValueError, match=r"'a\.gif' is no name of a picture; end it with \.png"):
        picture_kind(Path("a.gif"))
