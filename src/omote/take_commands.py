"""The commands `omote play-take`, which plays a recording of a tracker into a running show, and `omote record-take`."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.interchange.formats.file_kinds import suffixes_of
from omote.terminal import exit_on_refusal, fail, fail_with, say

if TYPE_CHECKING:
    from omote.inputs.takes.take import Take

CAPTURES = suffixes_of("capture")
TABLES = suffixes_of("take")
QUIET_SECONDS = 5
"""Seconds without a packet, after which a recording says so, again and again."""
SLOWEST = 0.05
FASTEST = 20.0


def read_speed(text: str | float) -> float:
    """How fast a take is played, as it is typed."""
    try:
        speed = float(text)
    except ValueError:
        speed = math.nan
    if not SLOWEST <= speed <= FASTEST:
        raise typer.BadParameter(
            f"{str(text)[:20]!r} is no speed; give a number from {SLOWEST:g} to {FASTEST:g}, 1 is as it was recorded"
        )
    return speed


def play_take(
    take: Annotated[
        Path, typer.Argument(help="A recording: Live Link Face (.csv), packets (.pcap, .pcapng), VMC packets (.json).")
    ],
    address: Annotated[
        str, typer.Option("--show", metavar="ADDRESS", help="The running show, as `omote show` prints it.")
    ] = "http://127.0.0.1:8090",
    character: Annotated[str, typer.Option(help="Whom it drives, by name or label; the first one without it.")] = "",
    layer: Annotated[str, typer.Option(help="The layer that it drives: playback, tracker, lips.")] = "playback",
    authority: Annotated[
        Path | None, typer.Option(help="What /certificate of a show with https gives, saved to a file (.pem).")
    ] = None,
    loop: Annotated[bool, typer.Option("--loop", help="Play it again and again, until Ctrl-C.")] = False,
    start: Annotated[float, typer.Option("--from", min=0.0, help="Seconds from its beginning.")] = 0.0,
    speed: Annotated[
        float, typer.Option(parser=read_speed, metavar="NUMBER", help="0.05 to 20; 1 is as it was recorded.")
    ] = 1.0,
    protocol: Annotated[
        str, typer.Option(help="What packets are, as --listen spells it; by their port without it.")
    ] = "",
) -> None:
    """Plays a recorded face into a running show."""
    read = read_take(take, protocol)
    from omote.client.connect import connect  # what is heavy comes after what can be refused without it
    from omote.client.take_player import play_take as play
    from omote.perform.layers.layer_names import check_driven
    from omote.perform.scene.character_names import ALL

    how = "again and again, until Ctrl-C" if loop else "once"
    say(f"{take.name} waits for the show at {address} ...")
    with exit_on_refusal(), connect(address, name="take", authority=authority) as show:
        name = show.find_character(character or show.characters[0])
        drive = show[name].drive
        whom = "all" if name == ALL else show.state.characters[name].label or name
        check_driven(layer)
        say(f"{take.name} plays {whom} on the layer {layer}, {how}: {len(read.times)} frames in {read.seconds:.1f} s.")
        while play(read, drive, layer=layer, start=min(start, read.seconds), speed=speed) and loop:
            pass
    say(f"{take.name} is over.")


def read_take(path: Path, protocol: str = "") -> Take:
    """The recording in a file, and a word where it is cut off; ends the command where it cannot be read.

    path: of the file; protocol: as options spell it, "" where the port says it.
    """
    from omote.inputs.takes.live_link_take import is_table_cut, read_live_link_take
    from omote.inputs.takes.packet_capture import is_capture_cut, read_packets
    from omote.inputs.takes.packet_take import choose_protocol, read_packet_take
    from omote.inputs.trackers.loose_json import read_text

    try:
        data = path.read_bytes()
        check_kind(path, data)
        if path.suffix.lower() in TABLES:
            text = read_text(data)
            if not text.strip() or "\0" in text:
                raise ValueError("it is no text of Live Link Face (.csv)")
            take = read_live_link_take(text)
            cut = is_table_cut(text)
        else:
            packets = read_packets(data)
            take = read_packet_take(packets, choose_protocol(packets, protocol))
            cut = is_capture_cut(data)
    except (OSError, ValueError) as error:
        fail_with(error if isinstance(error, OSError) else ValueError(f"{path}: {error}"))
    for note in take.notes:
        say(f"{path.name}: {note}.")
    if cut:
        say(f"{path.name} is cut off: what it holds is played; copy or record it anew to have all of it.")
    return take


def check_kind(path: Path, data: bytes) -> None:
    """Refuses a file (path, data) that is empty, or whose name is none of a recording, by ValueError."""
    if not data.strip():
        raise ValueError("it is empty")
    if path.suffix.lower() not in (*CAPTURES, *TABLES):
        raise ValueError(
            f"it is no recording by its name: play a table of Live Link Face ({TABLES[0]}), or packets "
            f"({', '.join(CAPTURES)})"
        )


def record_take(
    take: Annotated[Path, typer.Argument(help="The file to write (.pcap).")],
    listen: Annotated[
        str, typer.Option(metavar="TRACKER", help="What to record, as of omote show: vmc, livelink:11112.")
    ],
    seconds: Annotated[
        float | None, typer.Option(min=0.1, help="For how long from the first packet; until Ctrl-C without it.")
    ] = None,
) -> None:
    """Records what a tracker sends, to be played into a show later."""
    from omote.inputs.trackers.tracker_protocols import advise
    from omote.server.access.show_addresses import own_address
    from omote.server.devices.trackers.take_recorder import check_recordable
    from omote.server.devices.trackers.take_recorder import record_take as record
    from omote.server.devices.trackers.tracker_sockets import find_phones, read_wish

    path = take if take.suffix else take.with_suffix(".pcap")

    def announce(port: int) -> None:
        say(f"{wish.protocol.title} is recorded at port {port} into {path.name}; Ctrl-C ends it.")

    try:
        (wish,) = find_phones([read_wish(listen.strip())])
        check_recordable(wish)
        length = float("inf") if seconds is None else seconds
        count = record(path, wish, seconds=length, opened=announce, tell=_tell)
    except (OSError, ValueError) as error:
        fail_with(error)
    if not count:
        advice = advise(wish.protocol, own_address() or "127.0.0.1", wish.port)
        fail(f"no packet came, so {path.name} was not written: {advice}.")
    say(f"{path.name} holds {count} packets: omote play-take {path.name} --protocol {wish.protocol.name}")


def _tell(count: int, host: str, silent: float) -> None:
    if silent < QUIET_SECONDS:
        typer.echo(f"  {count} packets, the newest from {host}" if count else "  no packet yet")
    elif round(silent) % QUIET_SECONDS == 0:
        typer.echo(f"  nothing for {silent:.0f} s" + (f" after {count} packets" if count else ""))
