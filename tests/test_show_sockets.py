"""What the options of `omote show` ask for, of trackers; of OSC and lighting desks, see test_show_command."""

import socket
from pathlib import Path

import pytest
import typer

from omote.show_sockets import OFF, list_others, open_devices, print_trackers, read_options


def test_trackers_are_read_opened_and_printed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("omote.server.access.show_addresses.own_address", lambda: "192.0.2.2")
    options = read_options("off", None, "", "vmc:0,ifacialmocap:0@localhost")
    assert options.listen == "vmc:0,ifacialmocap:0@127.0.0.1"
    devices = open_devices("127.0.0.1", OFF, options, OFF)
    assert list(devices.handed) == ["--tracker-vmc", "--tracker-ifacialmocap"]
    assert devices.heard == ["VMC", "iFacialMocap"]
    print_trackers(devices.advice, "")
    said = capsys.readouterr()
    assert "  tracker     VMC: port " in said.out
    assert "--allow 192.0.2.0/24" in said.err
    print_trackers(devices.advice, "any")
    assert capsys.readouterr().err == ""
    devices.close()
    print_trackers([], "")
    assert capsys.readouterr().out == ""


def test_what_has_no_socket_here_is_listed_and_receivers_are() -> None:
    options = read_options(
        "off", None, "", "vmc,mediapipe,vtubestudio-pc@127.0.0.1", "livelink:10.0.0.5=dog,vmc:10.0.0.6"
    )
    first, second, third, fourth = list_others(options)
    assert first.startswith("tracker  VTube Studio PC: in VTube Studio turn") or first.startswith("tracker  MediaPipe")
    assert second.startswith("tracker  ")
    assert third == "sends    Live Link Face (Unreal) at 10.0.0.5:11111: dog"
    assert fourth == "sends    VMC (VSeeFace, Warudo, Unity) at 10.0.0.6:39539: the first character"


def test_a_tracker_whose_port_is_taken_is_off_and_the_show_opens(capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("", 0))
        port = other.getsockname()[1]
        options = read_options("off", None, "", f"livelink:{port},vmc:0")
        devices = open_devices("127.0.0.1", OFF, options, OFF)
    assert list(devices.handed) == ["--tracker-vmc"]
    assert f"Live Link Face is off: port {port} cannot be opened" in capsys.readouterr().err
    devices.close()


@pytest.mark.parametrize(
    ("text", "why"),
    [("livlink", "there is no tracker 'livlink'; near are livelink"), ("mediapipe@10.0.0.7", "names nobody")],
)
def test_what_is_no_tracker_ends_the_command(text: str, why: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(typer.Exit):
        read_options("off", None, "", text)
    assert why in capsys.readouterr().err


def test_a_picture_is_no_file_of_bindings(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    picture = tmp_path / "pic.jpg"
    picture.write_bytes(b"\xff\xd8\xff")
    with pytest.raises(typer.Exit):
        read_options("off", picture, "", "")
    assert "pic.jpg: its text is not UTF-8" in capsys.readouterr().err


def test_where_faces_are_sent_is_read_and_never_to_the_show_itself(capsys: pytest.CaptureFixture[str]) -> None:
    options = read_options("off", None, "", "vmc", "vmc:10.0.0.5, osc:127.0.0.1:9001=dog")
    assert options.send == "vmc:10.0.0.5:39539,osc:127.0.0.1:9001=dog"
    for send in ("vmc:localhost", "vmc"):
        with pytest.raises(typer.Exit):
            read_options("off", None, "", "vmc", send)
    assert "its own face" in capsys.readouterr().err
