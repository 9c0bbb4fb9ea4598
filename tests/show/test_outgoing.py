"""What leaves a session is one client's, and equal where it says the same to the same."""

from omote.show import messages as wire
from omote.show.outgoing import KeepRequest, Outgoing


def test_a_message_and_a_request_belong_to_a_client() -> None:
    pong = wire.Pong(1.0, 2.0)
    assert Outgoing("a", pong) == Outgoing("a", wire.Pong(1.0, 2.0))
    assert Outgoing("a", pong) != Outgoing("b", pong)
    asked = wire.DeleteItem("1", "face", "old")
    assert KeepRequest("a", asked).message is asked
