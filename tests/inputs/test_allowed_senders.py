"""Who may play by packets."""

import pytest

from omote.inputs.allowed_senders import MOST_REMEMBERED, THIS_MACHINE, read_senders


@pytest.mark.parametrize("host", ["127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"])
def test_this_machine_is_always_heard(host: str) -> None:
    assert THIS_MACHINE.allows(host)
    assert read_senders("10.0.0.7").allows(host)


@pytest.mark.parametrize("host", ["192.168.1.7", "10.0.0.8", "::ffff:10.0.0.8", "fe80::1%eth0", "nobody", ""])
def test_nobody_else_is_heard_unless_named(host: str) -> None:
    assert not THIS_MACHINE.allows(host)
    assert not read_senders("10.0.0.7").allows(host)


def test_addresses_and_networks_are_heard_and_remembered() -> None:
    senders = read_senders("192.168.1.0/24, 10.0.0.7,fe80::/10")
    for host, heard in (("192.168.1.255", True), ("192.168.2.1", False), ("10.0.0.7", True), ("fe80::1%eth0", True)):
        assert (senders.allows(host), senders.allows(host)) == (heard, heard)
    for number in range(2 * MOST_REMEMBERED):
        senders.allows(f"10.1.{number // 256}.{number % 256}")
    assert len(senders._verdicts) == MOST_REMEMBERED


def test_a_host_is_added() -> None:
    added = THIS_MACHINE.with_host("192.168.1.7")
    assert [added.allows(host) for host in ("127.0.0.1", "192.168.1.7", "192.168.1.8")] == [True, True, False]
    assert read_senders("any").with_host("192.168.1.7").allows("8.8.8.8")
    assert THIS_MACHINE.with_host(None) == THIS_MACHINE


def test_any_is_everybody() -> None:
    assert all(read_senders(" Any ").allows(host) for host in ("8.8.8.8", "2001:db8::1"))


@pytest.mark.parametrize(
    ("text", "why"),
    [("", "no sender"), (" ,", "no sender"), ("desk", "neither an address"), ("192.168.1.7/24", "bits behind")],
)
def test_what_is_no_network_is_said(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_senders(text)
