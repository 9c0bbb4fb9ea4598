"""The reference of the wire has every message with every field, and stops at a type that it has no words for."""

from __future__ import annotations

import re

import msgspec
import pytest

from omote.edit.protocol import messages as editing
from omote.show import messages as show
from omote.show.objects.calls import CallFace
from omote.show.objects.link import Hello
from tools.website.wire_reference import section, wire_page


def test_every_message_has_its_section_once() -> None:
    tags = re.findall(r"^### `(.*?)`(?: .*)?$", wire_page(), re.MULTILINE)
    structs = {
        *show.CLIENT_MESSAGES,
        *show.SERVER_MESSAGES,
        *editing.EDITOR_MESSAGES,
        *editing.ANSWERS,
        *show.DOCUMENTS,
    }
    titles = re.findall(r"^### (.*)$", wire_page(), re.MULTILINE)
    assert len(titles) == len(set(titles))
    assert {str(s.__struct_config__.tag or s.__name__) for s in structs} <= set(tags)


def test_a_message_of_both_links_has_one_section_and_is_named_at_the_other() -> None:
    show, sent = wire_page().split("## Editor: client to server")
    sent, answered = sent.split("## Editor: server to client")
    for tag, there in (("cancel", sent), ("notices", answered), ("progress", answered)):
        assert f"### `{tag}`\n" in show
        assert f"### `{tag}`\n" not in there
        assert f"`{tag}`" in there.split("Of the show's too: ")[1].split(".")[0]


def test_links_between_types_lead_to_sections_of_the_page() -> None:
    page = wire_page()
    sections = {re.sub(r"[^\w-]", "", title.lower()) for title in re.findall(r"^### (.*)$", page, re.MULTILINE)}
    assert {*re.findall(r"\]\(#(.*?)\)", page)} <= sections


def test_fields_are_described_in_words() -> None:
    text = section(CallFace)
    assert "| `name` | text, 1 to 80 long |" in text
    assert "| `seconds` | float or nothing |" in text
    assert "`stage`, `console`" in section(Hello)


def test_a_type_without_words_stops_the_page() -> None:
    strange = msgspec.defstruct("Strange", [("thing", complex)])
    with pytest.raises(TypeError, match="no words for"):
        section(strange)
