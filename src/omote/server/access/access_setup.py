"""What a show off loopback is opened with: its list of people and its certificate, handed on to every server of it."""

from __future__ import annotations

import argparse
import ssl
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from omote.server.access.access_control import AccessControl
from omote.server.access.certificates import CertificateFiles, load_context
from omote.server.access.people_file import read_people
from omote.server.access.security import check_embedder
from omote.show.access.people_list import People


@dataclass(frozen=True)
class AccessOptions:
    """What a server is told: the paths of the list of people, of a certificate, its key and its authority, "" for
    none; embed: the origins of pages that may show a stage in a frame, by spaces."""

    people: str = ""
    certificate: str = ""
    key: str = ""
    authority: str = ""
    embed: str = ""

    @property
    def words(self) -> list[str]:
        """The words of a standby's command line that say the same."""
        named = {"--people": self.people, "--certificate": self.certificate, "--key": self.key}
        named |= {"--authority": self.authority, "--embed": self.embed}
        return [word for name, value in named.items() if value for word in (name, value)]


@dataclass(frozen=True)
class AccessSetup:
    """The same as it was read, by a standby before it forks: what servers have where the files are gone meanwhile."""

    people_path: Path | None = None
    people: People | None = None
    tls: ssl.SSLContext | None = None
    authority: bytes | None = None
    embedders: tuple[str, ...] = ()

    def open_control(self, report: Callable[[str], None]) -> AccessControl | None:
        """Who may play, by the list as it is now; None where everybody may who reaches the show."""
        if self.people_path is None or self.people is None:
            return None
        people = self.people
        try:
            people = read_people(self.people_path)
        except (OSError, ValueError) as error:
            report(f"{error} Until then the tokens stay as they were.")
        return AccessControl(self.people_path, people, report=report)


OPEN_TO_ALL = AccessSetup()


def add_access_options(parser: argparse.ArgumentParser) -> None:
    """Adds what `read_access_options` reads."""
    for name in ("--people", "--certificate", "--key", "--authority", "--embed"):
        parser.add_argument(name, default="")


def read_access_options(options: argparse.Namespace) -> AccessOptions:
    """What a standby was told."""
    return AccessOptions(options.people, options.certificate, options.key, options.authority, options.embed)


def load_access(options: AccessOptions) -> AccessSetup:
    """Reads all that the options name; OSError or ValueError with a message."""
    tls = None
    if options.certificate:
        tls = load_context(CertificateFiles(Path(options.certificate), Path(options.key)))
    authority = Path(options.authority).read_bytes() if options.authority else None
    embedders = tuple(check_embedder(origin) for origin in options.embed.split())
    if not options.people:
        return AccessSetup(tls=tls, authority=authority, embedders=embedders)
    path = Path(options.people)
    return AccessSetup(path, read_people(path), tls, authority, embedders)
