"""A client of a session that is one source: it joins once, opens its source, and hears why it is refused."""

from omote.inputs.source_client import SourceClient
from omote.model.cast import Cast
from omote.show.session import ShowSession


def test_a_client_opens_its_source_and_does_so_anew_once_it_was_thrown_out(cast: Cast) -> None:
    session = ShowSession(cast)
    client = SourceClient("Ada", "tracker ada")
    client.join(session)
    assert client.open(session, "tracker", ["jawOpen"], 0.0) == []
    assert client.index is not None
    assert [source.name for source in session.sources.states({})] == ["Ada"]
    assert list(session.sources.route("Ada").characters) == list(session.scene)
    opened = client.index
    client.join(session)
    assert client.index == opened
    session.leave(client.who)
    client.join(session)
    assert client.index is None


def test_a_client_hears_why_its_source_is_refused(cast: Cast) -> None:
    session = ShowSession(cast)
    clients = [SourceClient("Ada", who) for who in ("first", "second")]
    for client in clients:
        client.join(session)
    reasons = [client.open(session, "tracker", ["jawOpen"], 0.0) for client in clients]
    assert reasons == [[], ["another link sends as Ada already; choose another name."]]
    assert [client.index is None for client in clients] == [False, True]
