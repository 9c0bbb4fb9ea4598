"""What is typed after --listen, and the sockets that are opened for it."""

import socket

import pytest

from omote.inputs.face_output.face_target import read_targets
from omote.inputs.trackers.tracker_protocols import TRACKER_PROTOCOLS
from omote.server.devices.trackers.tracker_sockets import (
    TrackerWish,
    explain_trackers,
    find_phones,
    find_receivers,
    listen_for_trackers,
    read_trackers,
)

VMC = TRACKER_PROTOCOLS["vmc"]
PHONES = TRACKER_PROTOCOLS["ifacialmocap"]


def test_a_list_is_read_as_it_is_typed() -> None:
    assert read_trackers("") == ()
    assert [wish.word for wish in read_trackers("mediapipe")] == ["mediapipe"]
    assert listen_for_trackers(read_trackers("mediapipe"), list[str]().append) == {}
    assert read_trackers("vmc") == (TrackerWish(VMC, 39539),)
    typed = read_trackers(" VMC:5000 , ifacialmocap:0@phone.local")
    assert typed == (TrackerWish(VMC, 5000), TrackerWish(PHONES, 0, "phone.local"))
    assert read_trackers(",".join(wish.word for wish in typed)) == typed


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("vcm", "vmc"),
        ("vmc,", "tracker"),
        ("vmc,vmc:1", "twice"),
        ("vmc:", "left out"),
        ("vmc:70000", "is 70000; give a number from 0 to 65535"),
        ("vmc:port", "is port; give"),
        ("mediapipe@10.0.0.7", "names nobody"),
        ("ifacialmocap@", "names nobody"),
        ("mediapipe:80", "port of the pages"),
    ],
)
def test_what_is_no_list_is_said(text: str, why: str) -> None:
    with pytest.raises(ValueError, match=why):
        read_trackers(text)


def test_a_phone_is_kept_by_its_address() -> None:
    (found,) = find_phones(read_trackers("ifacialmocap@localhost"))
    assert found.phone == "127.0.0.1"
    with pytest.raises(OSError, match="no address of xxx"):
        find_phones(read_trackers("ifacialmocap@" + "x" * 300))


def test_a_receiver_is_kept_by_its_address() -> None:
    (found,) = find_receivers(read_targets("vmc:localhost"))
    assert found.word == "vmc:127.0.0.1:39539"


def test_sockets_are_opened_and_explained_and_one_that_is_taken_is_said() -> None:
    opened = listen_for_trackers(read_trackers("vmc:0,livelink:0"), list[str]().append)
    port = opened["vmc"].getsockname()[1]
    first, second = explain_trackers(opened)
    assert first.startswith(f"tracker  VMC: port {port}; ")
    assert second.startswith("tracker  Live Link Face: port")
    said: list[str] = []
    others = listen_for_trackers(read_trackers(f"livelink:0,vmc:{port}"), said.append)
    assert list(others) == ["livelink"]
    (sentence,) = said
    assert sentence.startswith(f"VMC is off: port {port} cannot be opened for VMC (another program has it): ")
    for each in (*opened.values(), *others.values()):
        assert each.type == socket.SOCK_DGRAM
        each.close()
