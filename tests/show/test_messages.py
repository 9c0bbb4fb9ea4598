"""The messages themselves: tags, and that both directions survive the wire."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omote.show.declaration import snake_case
from omote.show.messages import CLIENT_MESSAGES, SERVER_MESSAGES
from omote.show.objects.calls import CallFace
from omote.show.wire import decode, decode_answer, encode
from tests.wire_samples import sample_of


def test_every_message_has_a_tag_of_its_own() -> None:
    tags = [message.__struct_config__.tag for message in (*CLIENT_MESSAGES, *SERVER_MESSAGES)]
    assert len(set(tags)) == len(tags)
    assert {"hello", "call_face", "set_channel", "welcome", "state", "refused"} <= set(tags)


@pytest.mark.parametrize(("name", "tag"), [("Hello", "hello"), ("CallFace", "call_face"), ("SetHead", "set_head")])
def test_a_tag_is_the_name_in_lower_case(name: str, tag: str) -> None:
    assert snake_case(name) == tag


def test_what_a_client_says_comes_over_the_wire_unchanged() -> None:
    for message in map(sample_of, CLIENT_MESSAGES):
        assert decode(encode(message)) == message


def test_what_the_server_says_comes_over_the_wire_unchanged() -> None:
    for message in map(sample_of, SERVER_MESSAGES):
        assert decode_answer(encode(message)) == message


@given(st.floats(0.0, 600.0), st.text(min_size=1, max_size=80))
def test_numbers_and_names_travel_exactly(seconds: float, name: str) -> None:
    message = CallFace("one", "id", name, seconds, "smooth")
    assert decode(encode(message)) == message
