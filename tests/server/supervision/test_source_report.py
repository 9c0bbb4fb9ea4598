"""Who plays whom is said on the terminal when it changes, and only then."""

from omote.model.cast import Cast
from omote.server.supervision.source_report import SourceReport
from omote.show.declaration import ClientMessage
from omote.show.messages import PROTOCOL_VERSION
from omote.show.objects.characters import AddCharacter
from omote.show.objects.link import Hello
from omote.show.objects.sources import Drive, LeaveSource, RouteSource, Source, SourceIs
from omote.show.session import ShowSession


def test_performers_and_whom_they_play_are_said_once(cast: Cast) -> None:
    session = ShowSession(cast)
    said = list[str]()
    now = 0.0
    report = SourceReport(lambda: session, said.append)

    def hear(*messages: ClientMessage) -> list[str]:
        nonlocal now
        for message in messages:
            session.receive("phone", message, now)
        report.hear(now)
        for _ in range(3):
            now += 1.0
            report.tell(session.tick(now), now)
        told = said.copy()
        said.clear()
        return told

    assert hear(Hello("console", PROTOCOL_VERSION, "phone")) == []
    assert hear(AddCharacter("a", "two", "Rex", "generic"), Source("bot", "program", [])) == []
    nobody = ["Mira sends and plays nobody: say at the console whom it plays (One or Rex)."]
    assert hear(Source("Mira", "tracker", ["jawOpen"])) == nobody
    assert hear(AddCharacter("d", "three", "Three", "generic")) == []  # it waits as before: nothing new to do
    assert hear(RouteSource("b", "Mira", ["one", "two"], "tracker")) == ["Mira plays One and Rex."]
    assert hear(RouteSource("c", "Mira", ["*"], "tracker")) == ["Mira plays all characters."]
    waits = "Mira sends and plays nobody: say at the console whom it plays (One or Rex or Three)."
    assert hear(RouteSource("e", "Mira", [], "tracker")) == [waits]
    assert hear(RouteSource("f", "Mira", ["*"], "tracker")) == ["Mira plays all characters."]
    assert hear(LeaveSource(2)) == []
    assert hear(Source("Mira", "tracker", ["jawOpen"])) == ["Mira plays all characters."]


def test_one_that_waits_behind_another_is_not_said_to_play(cast: Cast) -> None:
    session = ShowSession(cast)
    said = list[str]()
    now = 0.0
    report = SourceReport(lambda: session, said.append)
    indexes = dict[str, int]()
    frame = bytes(4)

    def open_source(who: str, *characters: str) -> None:
        session.receive(who, Hello("console", PROTOCOL_VERSION, who), now)
        (answer,) = session.receive(who, Source(who, "tracker", ["jawOpen"], list(characters)), now)
        assert isinstance(answer.message, SourceIs)
        indexes[who] = answer.message.index

    def play(*senders: str) -> list[str]:
        nonlocal now
        said.clear()
        for _ in range(70):
            for who in senders:
                session.receive(who, Drive(indexes[who], frame), now)
            now += 1.0 / 60.0
            report.tell(session.tick(now), now)
        return said.copy()

    open_source("camera", "one")
    assert play("camera") == ["camera plays One."]
    session.leave("camera")
    open_source("phone", "one")
    assert play("phone") == ["phone plays One."]
    open_source("camera")
    assert play("phone", "camera") == ["camera waits: phone plays One; choose at the console who does."]
    assert play("phone", "camera") == []
