"""The commands `omote access ...`: who may play a show off loopback; and what `omote show` prints of it.

They change the list beside the show file, also while the show plays: it takes the change up within a second.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omote.terminal import complete_show, escape_controls, exit_on_refusal, fail, say

if TYPE_CHECKING:
    from omote.show.access.people_list import People, Person

ROLES_HELP = "view (stages), operate (consoles), edit (editors too) or admin (tokens too)."
ShowArgument = Annotated[
    Path | None, typer.Argument(callback=complete_show, help="The show file (.omote); the usual one without it.")
]
AddressOption = Annotated[
    str, typer.Option(metavar="URL", help="Where the show is reached; where it was played last without it.")
]

LOCAL_ONLY = "the show was opened for this machine alone: others reach it after a start with --host 0.0.0.0."
GUESSED = "the address is guessed, for this show was not played here yet: give --address http://192.168.1.7:8090."


def check_name(name: str) -> str:
    """A name as it is typed; ends the command where it is a show file's, which comes after it."""
    if name.lower().endswith(".omote"):
        fail(f"{name[:80]!r} is a show file; the name comes first: omote access code Ada evening.omote")
    return name


access_app = typer.Typer(help="Says who may play a show on a network, and changes it.", no_args_is_help=True)


@access_app.command("list")
def list_people(show: ShowArgument = None) -> None:
    """Lists who has a token, and with which role."""
    with exit_on_refusal():
        people = _read(show)
    for person in people.people:
        typer.echo(f"  {person.role:<8} {escape_controls(person.name):<24} {_describe_end(person)}")


@access_app.command()
def add(
    name: Annotated[
        str,
        typer.Argument(
            callback=check_name, help="Who it is for, 1 to 24 letters; the others read it on their consoles."
        ),
    ],
    show: ShowArgument = None,
    role: Annotated[str, typer.Option(help=ROLES_HELP)] = "operate",
    hours: Annotated[float | None, typer.Option(help="For how long; for ever without it.")] = None,
    address: AddressOption = "",
) -> None:
    """Makes a token, and prints the address and the QR code by which its person enters."""
    from omote.server.access.people_file import change_people, new_person
    from omote.show.access.access_role import ACCESS_ROLES
    from omote.show.access.people_list import add_person, check_hours

    chosen = next((access_role for access_role in ACCESS_ROLES if access_role == role.strip().lower()), None)
    if chosen is None:
        fail(f"{role[:40]!r} is no role; give {ROLES_HELP}")
    with exit_on_refusal():
        _read(show)
        base = _find_base(show, address)
        person = new_person(name, chosen, _wall(), check_hours(hours))
        people = change_people(_path(show), lambda before: add_person(before, person))
        print_entry(people, person, base)


@access_app.command()
def code(
    name: Annotated[str, typer.Argument(callback=check_name, help="Whose; omote access list names them.")],
    show: ShowArgument = None,
    address: AddressOption = "",
) -> None:
    """Prints somebody's address and QR code again."""
    from omote.show.access.people_list import find_named

    with exit_on_refusal():
        people = _read(show)
        print_entry(people, find_named(people, name), _find_base(show, address))


@access_app.command()
def revoke(name: Annotated[str, typer.Argument(callback=check_name, help="Whose.")], show: ShowArgument = None) -> None:
    """Revokes a token: the links that came by it close within a second."""
    from omote.server.access.people_file import change_people
    from omote.show.access.people_list import remove_person

    with exit_on_refusal():
        _read(show)
        change_people(_path(show), lambda before: remove_person(before, name)[0])
    say(f"the token of {name} is not valid any more.")


def note_place(lock: int, host: str, port: int, *, secure: bool) -> str:
    """Writes where a show listens into its lock file, for these commands; returns the scheme of its addresses.

    host, port: where it listens; secure: whether by https.
    """
    from omote.server.access.show_addresses import url
    from omote.server.persistence.lock import note_address

    scheme = "https" if secure else "http"
    note_address(lock, url(host, port, scheme))
    return scheme


def print_shared(people: People, base: str, *, colour: bool) -> None:
    """Prints the addresses by which those enter who have no token of their own, and the code for a console.

    people: all who have tokens; base: the show's address; colour: whether the terminal shows it.
    """
    from omote.server.access.show_addresses import entry_address
    from omote.show.access.people_list import token_of

    shared = {holder.role: holder for holder in people.people if holder.name == holder.role}
    typer.echo("  Who has one of these addresses may enter, with the role that stands before it:")
    for role, person in shared.items():
        typer.echo(f"  {role:<8} {entry_address(base, role, token_of(people, person))}")
    if "operate" in shared:
        code = read_code(entry_address(base, "operate", token_of(people, shared["operate"])), colour=colour)
        typer.echo(f"\n{code}\n")
        typer.echo("  A phone or a tablet that reads this picture opens the console (operate).")
    others = "/solo, /clips, /notes, /runs, /camera, /microphone and /devices"
    typer.echo(f"  The pages {base}/cues, {others} open in the same browser (operate).")
    typer.echo("  omote access, and People on a console of an admin, list, make and revoke tokens.")


def print_entry(people: People, person: Person, base: str) -> None:
    """Prints the address and the QR code of one person. people: all who have tokens; base: the show's address."""
    from omote.server.access.show_addresses import entry_address
    from omote.show.access.people_list import token_of

    address = entry_address(base, person.role, token_of(people, person))
    typer.echo(f"  {person.role:<8} {escape_controls(person.name):<24} {_describe_end(person)}\n  {address}\n")
    typer.echo(f"{read_code(address, colour=has_colour())}\n")


def has_colour() -> bool:
    """Whether standard output is a terminal that shows colours."""
    return sys.stdout.isatty() and "NO_COLOR" not in os.environ


def read_code(address: str, *, colour: bool) -> str:
    """The QR code of an address, as a terminal can draw it. colour: whether it shows colours."""
    from omote.server.access.qr_code import draw_qr_code

    return draw_qr_code(address, encoding=sys.stdout.encoding or "ascii", colour=colour)


def _read(show: Path | None) -> People:
    from omote.server.access.people_file import people_path, read_people
    from omote.showfile.identification import reject_foreign
    from omote.showfile.recovery import explain_missing

    place = _locate(show)
    path = people_path(place)
    if not path.exists():
        if reject_foreign(place).kind in ("missing", "empty"):
            raise ValueError(explain_missing(place))
        raise ValueError(
            f"there are no tokens for this show yet ({path.name} is not there): the first start with --host 0.0.0.0 "
            "makes them."
        )
    return read_people(path)


def _path(show: Path | None) -> Path:
    from omote.server.access.people_file import people_path

    return people_path(_locate(show))


def _locate(show: Path | None) -> Path:
    from omote.showfile.identification import locate_show
    from omote.showfile.show_file import default_path

    return locate_show(default_path() if show is None else show)


def _find_base(show: Path | None, address: str) -> str:
    """Where others reach the show: as the operator says, else as it was opened last, else a guess that says so."""
    from omote.client.show_address import base_address
    from omote.server.access.show_addresses import is_loopback, own_address, reachable_addresses, split_url, url
    from omote.server.persistence.lock import read_address

    scheme, host, port = split_url(read_address(_locate(show)))
    if address:
        return base_address(address, scheme)
    if not host or not port:
        say(GUESSED)
        return url(own_address() or "127.0.0.1", 8090)
    if is_loopback(host):
        say(LOCAL_ONLY)
    return reachable_addresses(host, port, scheme)[-1]


def _describe_end(person: Person) -> str:
    if person.until is None:
        return "for ever"
    ended = "ended" if person.until <= _wall() else "until"
    return f"{ended} {time.strftime('%Y-%m-%d %H:%M', time.localtime(person.until))}"


def _wall() -> float:
    """Seconds since 1970."""
    return time.time()  # noqa: TID251  (a token's end is a date)
