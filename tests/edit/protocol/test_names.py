"""Names are keys for ever: plain, new, and found again from no label; labels are what people read."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.edit.protocol.names import (
    LONGEST_LABEL,
    clean_label,
    clean_tags,
    clean_text,
    free_label,
    new_label,
    new_name,
    slug,
)
from omote.show.validation import Refusal


@given(st.text(max_size=200))
def test_a_name_is_plain_ascii_whatever_the_label(label: str) -> None:
    name = slug(label, "face")
    assert set(name) <= set("abcdefghijklmnopqrstuvwxyz0123456789_")
    assert 1 <= len(name) <= LONGEST_LABEL
    assert slug(name, "face") == name


@pytest.mark.parametrize(
    ("label", "name"),
    [("Crooked smile", "crooked_smile"), ("  Été à Noël! ", "ete_a_noel"), ("笑顔", "expression"), ("../etc", "etc")],
)
def test_names_read_like_their_labels(label: str, name: str) -> None:
    assert slug(label, "expression") == name


@given(st.lists(st.sampled_from(["Smile", "smile!", "SMILE", "笑顔", "Grin"]), max_size=20))
def test_names_are_new_whatever_letters_are_large(labels: list[str]) -> None:
    taken = {"browInnerUp", "Smile"}
    for label in labels:
        name = new_name(label, "expression", taken)
        assert name.casefold() not in {each.casefold() for each in taken}
        taken.add(name)


def test_own_labels_count_up_and_fill_gaps() -> None:
    assert new_label("On air", []) == "On air 1"
    assert new_label("On air", ["on air 1", "On air 3"]) == "On air 2"


@given(st.lists(st.sampled_from(["Smile", "smile", "Smile 2", "x" * LONGEST_LABEL]), max_size=12))
def test_free_labels_are_the_ones_wanted_as_long_as_nothing_has_them(wanted: list[str]) -> None:
    taken: list[str] = []
    for each in wanted:
        label = free_label(each, taken)
        assert label.casefold() not in {one.casefold() for one in taken}
        assert (label == each) == (each.casefold() not in {one.casefold() for one in taken})
        assert len(label) <= LONGEST_LABEL
        taken.append(label)


@pytest.mark.parametrize("label", ["", "   ", "a\nb", "x" * 81, "\x00", "\u202e"])
def test_labels_that_nobody_can_read_are_refused(label: str) -> None:
    with pytest.raises(Refusal, match="give 1 to 80 printable characters"):
        clean_label(label)


@pytest.mark.parametrize(
    ("label", "said"),
    [
        ("Ana\u202e", "the name has the character 'right-to-left override' in it"),
        ("Ana\nBo", "the name has a line break in it"),
        ("Ana\x07Bo", "the name has the character 'U+0007' in it"),
        ("x" * 81, "the name has 81 characters"),
        (" ", "the name is empty"),
    ],
)
def test_a_refused_label_is_said_in_words(label: str, said: str) -> None:
    with pytest.raises(Refusal) as refused:
        clean_label(label, "the name")
    assert str(refused.value).startswith(said)
    assert "\\" not in str(refused.value)


def test_labels_lose_blanks_and_tags_their_doubles() -> None:
    assert clean_label("  Crooked smile ") == "Crooked smile"
    assert clean_tags(["mouth", " mouth", "act 2"]) == ("mouth", "act 2")
    with pytest.raises(Refusal, match="a tag"):
        clean_tags(["mouth", "\n"])


def test_notes_may_be_empty_but_not_unreadable() -> None:
    assert clean_text("  ") == ""
    with pytest.raises(Refusal, match="printable"):
        clean_text("a\x07b")
