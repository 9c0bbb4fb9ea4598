"""Who plays whom is said on the terminal when it changes, and only then."""

from omote.model.cast import Cast
from omote.server.supervision.source_report import SourceReport
from omote.show import messages as wire
from omote.show.session import ShowSession


def test_performers_and_whom_they_play_are_said_once(cast: Cast) -> None:
    session, said, now = ShowSession(cast), list[str](), 0.0
    report = SourceReport(lambda: session, said.append)

    def hear(*messages: wire.FromClient) -> list[str]:
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

    assert hear(wire.Hello("console", wire.PROTOCOL_VERSION, "phone")) == []
    assert hear(wire.AddCharacter("a", "two", "Rex", "generic"), wire.Source("bot", "program", [])) == []
    nobody = ["Mira sends and plays nobody: say at the console whom it plays (One or Rex)."]
    assert hear(wire.Source("Mira", "tracker", ["jawOpen"])) == nobody
    assert hear(wire.AddCharacter("d", "three", "Three", "generic")) == []  # it waits as before: nothing new to do
    assert hear(wire.RouteSource("b", "Mira", ["one", "two"], "tracker")) == ["Mira plays One and Rex."]
    assert hear(wire.RouteSource("c", "Mira", ["*"], "tracker")) == ["Mira plays all characters."]
    waits = "Mira sends and plays nobody: say at the console whom it plays (One or Rex or Three)."
    assert hear(wire.RouteSource("e", "Mira", [], "tracker")) == [waits]
    assert hear(wire.RouteSource("f", "Mira", ["*"], "tracker")) == ["Mira plays all characters."]
    assert hear(wire.LeaveSource(2)) == []
    assert hear(wire.Source("Mira", "tracker", ["jawOpen"])) == ["Mira plays all characters."]
