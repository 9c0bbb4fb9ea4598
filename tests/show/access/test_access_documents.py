"""Documents about people pass the wire unchanged, and what asks wrongly is rejected."""

import msgspec
import pytest

from omote.show.access.access_documents import ACCESS_DOCUMENTS, NewPerson
from tests.wire_samples import sample_of


@pytest.mark.parametrize("kind", ACCESS_DOCUMENTS, ids=lambda kind: str(kind.__name__))
def test_a_document_comes_back_as_it_was(kind: type[msgspec.Struct]) -> None:
    sent = sample_of(kind)
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(sent), type=kind) == sent


@pytest.mark.parametrize("wrong", [{"name": ""}, {"name": "x" * 25}, {"role": "king"}, {"hours": "2"}])
def test_no_token_is_made_of_a_wrong_wish(wrong: dict[str, str]) -> None:
    wish = {"name": "Ada", "role": "view", "hours": None} | wrong
    with pytest.raises(msgspec.ValidationError):
        msgspec.msgpack.decode(msgspec.msgpack.encode(wish), type=NewPerson)
