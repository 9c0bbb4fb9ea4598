"""Names of mouth shapes of other programs."""

import pytest

from omote.perform.speech.viseme_names import AZURE, RHUBARB, shapes_of_azure, shapes_of_rhubarb, shapes_of_viseme
from omote.perform.speech.visemes import VISEMES


def test_all_ids_of_azure_are_visemes_and_closures_stay_closures() -> None:
    assert len(AZURE) == 22
    assert {shape for shapes in AZURE for shape in shapes} <= set(VISEMES)
    assert (shapes_of_azure("0"), shapes_of_azure("21"), shapes_of_azure("18")) == (("sil",), ("PP",), ("FF",))
    assert shapes_of_azure("11") == ("aa", "I")


def test_shapes_of_rhubarb_and_spellings_of_oculus_are_visemes() -> None:
    assert {shape for shapes in RHUBARB.values() for shape in shapes} <= set(VISEMES)
    assert shapes_of_rhubarb("A") == ("PP",)
    assert [shapes_of_viseme(name) for name in ("viseme_PP", "pp", "ih", "oh", "ou", "KK", "aa")] == [
        ("PP",), ("PP",), ("I",), ("O",), ("U",), ("kk",), ("aa",),
    ]  # fmt: skip


@pytest.mark.parametrize("name", ["22", "-1", "1.0", "", "²", "100", "a"])
def test_rejects_ids_that_azure_does_not_send(name: str) -> None:
    with pytest.raises(ValueError, match="give 0 to 21"):
        shapes_of_azure(name)


def test_rejects_shapes_and_visemes_that_there_are_not() -> None:
    with pytest.raises(ValueError, match="as Rhubarb writes"):
        shapes_of_rhubarb("a")
    with pytest.raises(ValueError, match="there is no viseme 'ZZ'"):
        shapes_of_viseme("ZZ")
