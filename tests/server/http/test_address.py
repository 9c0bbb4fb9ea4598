"""Where a show says that it can be reached."""

import ipaddress

import pytest

from omote.server.http.address import local_address, own_address, reachable_addresses, url


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("127.0.0.1", "http://127.0.0.1:8090"),
        ("0.0.0.0", "http://127.0.0.1:8090"),
        ("::", "http://127.0.0.1:8090"),
        ("::1", "http://[::1]:8090"),
        ("stage.local", "http://stage.local:8090"),
    ],
)
def test_a_browser_on_this_machine_finds_the_show(host: str, expected: str) -> None:
    assert local_address(host, 8090) == expected


def test_on_loopback_there_is_one_address() -> None:
    assert reachable_addresses("127.0.0.1", 1) == ["http://127.0.0.1:1"]


def test_for_the_network_there_is_the_outer_address_too() -> None:
    outer = own_address()
    expected = ["http://127.0.0.1:1"] if outer is None else ["http://127.0.0.1:1", url(outer, 1)]
    assert reachable_addresses("0.0.0.0", 1) == expected


def test_the_outer_address_is_one_that_others_can_use() -> None:
    outer = own_address()
    assert outer is None or not ipaddress.ip_address(outer).is_loopback
