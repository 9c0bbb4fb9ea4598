"""The table of protocols: what the options, the sockets and the manual are made of."""

import pytest

from omote.inputs.rejection import PacketError
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS, TrackerProtocol, advise


def unanswered(packet: bytes) -> None:
    raise AssertionError(packet)


EACH = pytest.mark.parametrize("protocol", TRACKER_PROTOCOLS.values(), ids=TRACKER_PROTOCOLS)


def test_each_has_a_port_of_its_own_but_for_those_that_one_vendor_s_apps_share() -> None:
    apps = {(each.port, each.name.partition("-")[0]) for each in TRACKER_PROTOCOLS.values() if not each.stream}
    assert len({port for port, _ in apps}) == len(apps)


@EACH
def test_each_says_what_to_do_with_this_machine_s_address(protocol: TrackerProtocol) -> None:
    said = advise(protocol, "192.168.1.10", 4711)
    assert "192.168.1.10" in said or f"--listen {protocol.name}@PHONE" in said or not protocol.heard
    assert "{" not in said


@EACH
def test_each_rejects_what_is_no_packet_of_it(protocol: TrackerProtocol) -> None:
    with pytest.raises(PacketError):
        protocol.open(unanswered)(b"hello")


@EACH
def test_what_asks_a_phone_has_a_port_to_ask_at(protocol: TrackerProtocol) -> None:
    assert (protocol.ask is None) == (protocol.phone_port is None)
    assert protocol.ask is None or protocol.ask(protocol.port or 0)
