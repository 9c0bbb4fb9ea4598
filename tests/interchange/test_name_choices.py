"""What people choose of a cast by name: hair. Expressions are chosen in test_export_face.py."""

import pytest

from omote.interchange.name_choices import choose_hair


def test_hair_is_a_style_none_or_left_out() -> None:
    assert [choose_hair(["bob", "bun"], word) for word in ("bun", "NONE", "")] == ["bun", "", None]
    with pytest.raises(ValueError, match="no hair 'afro'; choose one of bob, bun, or none"):
        choose_hair(["bob", "bun"], "afro")
