"""The permission matrix of messages: every message of both links with every role; a new message without a row fails."""

import msgspec
import pytest

from omote.edit.protocol import messages as editing
from omote.edit.protocol.wire import decode as decode_edit
from omote.model.cast import Cast
from omote.show.access.access_role import ACCESS_ROLES, HIGHEST, AccessRole, explain_missing_role, role_allows
from omote.show.access.people_list import Visitor
from omote.show.declaration import ClientMessage
from omote.show.messages import CLIENT_MESSAGES, PROTOCOL_VERSION
from omote.show.objects.calls import Panic
from omote.show.objects.link import Hello, Refused, Welcome
from omote.show.session import ShowSession
from omote.show.validation import Refusal
from tests.wire_samples import sample_of


def tag_of(kind: type[msgspec.Struct]) -> str:
    return str(kind.__struct_config__.tag)


def test_a_message_that_nobody_has_thought_of_needs_the_highest_role() -> None:
    class Unthought(ClientMessage, frozen=True):
        """New."""

    assert Unthought.access == HIGHEST


def session_of(role: AccessRole, cast: Cast) -> ShowSession:
    """A show in which "who" has a role and was welcomed."""
    session = ShowSession(cast)
    session.members.identify("who", Visitor(role, "Ada", "id"))
    assert isinstance(session.receive("who", Hello("console", PROTOCOL_VERSION), 0.0)[0].message, Welcome)
    return session


def refusals(session: ShowSession, kind: type[ClientMessage]) -> list[str]:
    """What "who" is told who sends a message of a kind."""
    answers = session.receive("who", sample_of(kind), 0.0)  # type: ignore[arg-type]
    return [each.message.reason for each in answers if isinstance(each.message, Refused)]


@pytest.mark.parametrize("role", ACCESS_ROLES)
def test_the_session_obeys_those_alone_whose_role_allows_it(role: AccessRole, cast: Cast) -> None:
    refused = [kind for kind in CLIENT_MESSAGES if not role_allows(role, kind.access)]
    for kind in {*CLIENT_MESSAGES} - {*refused}:
        assert refusals(session_of(role, cast), kind) != [explain_missing_role(role, kind.access)], tag_of(kind)
    session = session_of(role, cast)  # one for all: nothing that is refused changes it
    before = session.snapshot(), session.commands, session.crew
    for kind in refused:
        assert refusals(session, kind) == [explain_missing_role(role, kind.access)], tag_of(kind)
        assert (session.snapshot(), session.commands, session.crew) == before, tag_of(kind)
        assert session.take_keep_requests() == []
        assert session.take_cancelled() == []


@pytest.mark.parametrize("role", ACCESS_ROLES)
def test_editors_requests_are_read_of_those_alone_whose_role_allows_it(role: AccessRole) -> None:
    for kind in editing.EDITOR_MESSAGES:
        sent = sample_of(kind)
        needed = kind.access if issubclass(kind, editing.EditorMessage) else "edit"
        if role_allows(role, needed):
            assert decode_edit(msgspec.msgpack.encode(sent), role) == sent
        else:
            with pytest.raises(Refusal, match=f'"{needed}"'):
                decode_edit(msgspec.msgpack.encode(sent), role)


def test_who_has_no_token_because_none_is_asked_for_may_do_all(cast: Cast) -> None:
    session = ShowSession(cast)
    session.receive("who", Hello("console", PROTOCOL_VERSION), 0.0)
    assert session.receive("who", Panic("one"), 0.0) == []
