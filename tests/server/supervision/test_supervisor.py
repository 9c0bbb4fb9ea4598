"""Real processes: servers are killed, stopped and poisoned, and the show goes on."""

import asyncio
import contextlib
import datetime
import json
import os
import re
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from queue import Queue

import aiohttp
import msgspec
import pytest

import omote
from omote.edit.protocol import messages as editing
from omote.edit.protocol.messages import EDITING_PATH
from omote.server.access.access_setup import AccessOptions
from omote.server.access.certificates import make_certificate
from omote.server.access.people_file import open_people
from omote.server.persistence.lock import lock_show
from omote.server.persistence.memory_copy import find_copy, read_state
from omote.server.process.process_messages import REJECTED
from omote.server.supervision import supervisor
from omote.server.supervision.listening_socket import listen_on
from omote.server.supervision.start_limit import FAILURES
from omote.server.supervision.supervisor import HANG_SECONDS, LONGEST_EXCUSE, Server, Supervisor
from omote.show.access.people_list import token_of
from omote.show.declaration import ClientMessage
from omote.show.messages import LINK_PATH, PROTOCOL_VERSION
from omote.show.objects.calls import CallFace
from omote.show.objects.faders import SetChannel
from omote.show.objects.link import Hello, Notice, Notices, Ping, Pong
from omote.show.objects.state import State
from omote.show.wire import decode_answer, encode
from omote.showfile.inspection import inspect_show
from omote.showfile.schema import ShowFileError
from omote.showfile.show_file import JournalEntry, open_show
from tests.server.conftest import Editor

ROOT = Path(__file__).parents[3]
LIMIT = 60.0
"""Seconds after which a test has failed; nothing waits for them."""


class Show:
    """A supervisor in a process of its own, playing the synthetic cast."""

    def __init__(self, path: Path, **environment: str) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "tests.server.supervised", str(path)],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            env={**os.environ, **environment},
        )
        self.said: Queue[str] = Queue()
        threading.Thread(target=self._listen, daemon=True).start()
        self.url = self.heard(r"(http://\S+)")

    def _listen(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self.said.put(line)

    def heard(self, pattern: str) -> str:
        """Waits until something is said; the first group of the pattern."""
        while True:
            if found := re.search(pattern, self.said.get(timeout=LIMIT)):
                return found[1] if found.groups() else found[0]

    def standby(self) -> int:
        """The process id of the standby."""
        return children(self.process.pid)[0]

    def server(self) -> int:
        """The process id of the server that plays."""
        return server_of(self.standby())


def server_of(standby: int) -> int:
    """The process id of the server that a standby has started: it has workers, what makes a spare has none."""
    while True:
        for pid in reversed(children(standby)):
            with contextlib.suppress(OSError):
                if len(children(pid)) > 1:
                    return pid


def children(pid: int) -> list[int]:
    """The child processes of a process."""
    return [int(word) for word in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


@pytest.fixture
def show(tmp_path: Path) -> Iterator[Show]:
    """A show that plays; it ends with the test."""
    yield from played(Show(tmp_path / "a.omote"))


def played(started: Show) -> Iterator[Show]:
    """A show until whoever has it is done."""
    yield started
    with contextlib.suppress(ProcessLookupError):
        started.process.terminate()
    assert started.process.wait(LIMIT) in (0, -signal.SIGKILL)
    if started.process.stdout:
        started.process.stdout.close()


async def next_state(http: aiohttp.ClientSession, url: str, *say: ClientMessage, above: int = 0) -> State:
    """Opens a link until it works, says something, and gives the first state of an epoch above `above` that follows."""
    while True:
        with contextlib.suppress(aiohttp.ClientError, OSError):
            async with http.ws_connect(url + LINK_PATH) as link:
                for message in (Hello("console", PROTOCOL_VERSION), *say, Ping(0.0)):
                    await link.send_bytes(encode(message))
                heard = False
                while (received := await link.receive()).type is aiohttp.WSMsgType.BINARY:
                    answer = decode_answer(received.data)
                    heard = heard or isinstance(answer, Pong)
                    if isinstance(answer, State) and heard and answer.epoch > above:
                        return answer


def ask(show: Show, *say: ClientMessage, above: int = 0) -> State:
    """The next state of a show."""

    async def asked() -> State:
        async with aiohttp.ClientSession() as http:
            return await asyncio.wait_for(next_state(http, show.url, *say, above=above), LIMIT)

    return asyncio.run(asked())


def test_a_killed_server_is_replaced_and_the_fade_goes_on(show: Show) -> None:
    before = ask(show, CallFace("one", "1", "broad", 600.0, "smooth"), SetChannel("one", "jawOpen", 0.5))
    before = ask(show, above=before.epoch - 1)  # by now the journal has it, or the next one would not
    while not journalled(show, b"jawOpen"):
        before = ask(show)
    for _ in range(3):
        os.kill(show.server(), signal.SIGKILL)
        after = ask(show, above=before.epoch)
        assert after.characters["one"].channels == {"jawOpen": 0.5}
        assert after.characters["one"].face_call is not None
        assert after.characters["one"].face_call.target == "broad"
        assert after.time >= before.time - 1.0
        before = after


def test_https_and_tokens_outlive_a_killed_server_and_their_own_files(tmp_path: Path) -> None:
    made = make_certificate(["127.0.0.1"], now=datetime.datetime.now(datetime.UTC), folder=tmp_path / "https")
    people = open_people(tmp_path / "a.people")
    options = AccessOptions(str(tmp_path / "a.people"), str(made.certificate), str(made.key), str(made.authority))
    for show in played(Show(tmp_path / "a.omote", SYNTHETIC_ACCESS=json.dumps(vars(options)))):
        url = show.url.replace("http:", "https:")
        token = token_of(people, people.people[1])
        with omote.connect(url, token=token, authority=made.authority, timeout=LIMIT) as playing:
            playing["one"].set_channel("jawOpen", 0.5)
            before = playing.state
            for path in (tmp_path / "a.people", made.certificate, made.key):
                path.unlink()
            os.kill(show.server(), signal.SIGKILL)
            while playing.state.epoch == before.epoch:
                playing.wait()
            playing["one"].set_channel("smile", 0.25)
        with pytest.raises(ConnectionError, match="asks for a token, and this one is not valid"):
            omote.connect(url, authority=made.authority, timeout=LIMIT)
        with pytest.raises(ConnectionError, match="is not trusted by this machine"):
            omote.connect(url, token=token, timeout=1.0)


def notices(show: Show, count: int) -> list[Notice]:
    """What a console is told once there are so many notices."""

    async def asked() -> list[Notice]:
        async with aiohttp.ClientSession() as http:
            while True:
                with contextlib.suppress(aiohttp.ClientError, OSError):
                    async with http.ws_connect(show.url + LINK_PATH) as link:
                        await link.send_bytes(encode(Hello("console", PROTOCOL_VERSION)))
                        while (received := await link.receive()).type is aiohttp.WSMsgType.BINARY:
                            answer = decode_answer(received.data)
                            if isinstance(answer, Notices) and len(answer.notices) >= count:
                                return answer.notices

    return asyncio.run(asyncio.wait_for(asked(), LIMIT))


def test_consoles_are_told_of_each_life_that_was_spent(show: Show) -> None:
    """Also those that come later, and from servers that came after the next."""
    spent = 0
    for spent in range(1, 4):
        before = ask(show)
        while not journalled(show, b"performer"):
            before = ask(show)
        os.kill(show.server(), signal.SIGKILL)
        ask(show, above=before.epoch)
        told = notices(show, spent)
        assert len(told) == spent
        assert "The show's process ended at " in told[-1].text
        assert "what was on air went on." in told[-1].text
    assert ["time in this show" in notice.text for notice in told] == [False, True, True]
    assert "3rd time" in told[-1].text
    assert len({notice.id for notice in told}) == spent


def replace_by_text(path: Path) -> None:
    text = path.with_name("notes.txt")
    text.write_text("milk and eggs")
    text.replace(path)


@pytest.mark.parametrize("beside", [False, True])
def test_a_killed_server_goes_on_although_its_file_was_moved_or_replaced(show: Show, beside: bool) -> None:
    path = Path(show.process.args[-1])  # type: ignore[index, arg-type]
    if beside:
        replace_by_text(path)
        show.heard("another file took the place of")
    else:
        path.rename(path.with_name("moved.omote"))
        show.heard("It was made anew there")
    before = ask(show, SetChannel("one", "jawOpen", 0.5))
    while not journalled(show, b"jawOpen", "a-2.omote" if beside else "a.omote"):
        before = ask(show)
    for _ in range(2):
        os.kill(show.server(), signal.SIGKILL)
        after = ask(show, above=before.epoch)
        assert after.characters["one"].channels == {"jawOpen": 0.5}
        before = after
    told = notices(show, 3)
    assert "during the show" in told[0].text
    assert "what was on air went on." in told[1].text
    assert (path.read_bytes() == b"milk and eggs") == beside


def test_a_killed_server_is_replaced_by_one_that_has_the_own_face_on_air(show: Show) -> None:
    async def authored() -> None:
        async with aiohttp.ClientSession() as http, http.ws_connect(show.url + EDITING_PATH, max_msg_size=0) as link:
            page = Editor(link)
            await page.greet()
            draft = await page.ask(editing.CreateFace, "Cousin", {"broad": 0.5, "long": 0.5}, False)
            assert isinstance(await page.ask(editing.Save, draft.item, ""), editing.Saved)

    asyncio.run(asyncio.wait_for(authored(), LIMIT))
    before = ask(show, CallFace("one", "1", "cousin", 0.0, "smooth"))
    while not journalled(show, b"cousin"):
        before = ask(show)
    os.kill(show.server(), signal.SIGKILL)
    assert ask(show, above=before.epoch).characters["one"].faces == {"cousin": 1.0}


def test_a_server_that_is_killed_while_the_disk_stalls_goes_on_from_memory_and_then_from_the_file(
    tmp_path: Path,
) -> None:
    """The own face on air too. Later work is kept in the file again, and nothing is left in memory at the end."""
    stall, path = tmp_path / "stall", tmp_path / "a.omote"
    copy = find_copy(path)
    if copy is None:
        pytest.skip("this system has no files in memory")

    async def author(url: str, label: str) -> object:
        async with aiohttp.ClientSession() as http, http.ws_connect(url + EDITING_PATH, max_msg_size=0) as link:
            page = Editor(link)
            await page.greet()
            draft = await page.ask(editing.CreateFace, label, {"broad": 0.5, "long": 0.5}, False)
            return await page.ask(editing.Save, draft.item, "") if isinstance(draft, editing.DraftState) else draft

    for show in played(Show(path, SYNTHETIC_STALL=str(stall))):
        assert isinstance(asyncio.run(asyncio.wait_for(author(show.url, "Cousin"), LIMIT)), editing.Saved)
        before = ask(show, CallFace("one", "1", "cousin", 0.0, "smooth"), SetChannel("one", "jawOpen", 0.5))
        while not (in_memory := read_state(copy)) or b"jawOpen" not in (in_memory.snapshot or b"") or not holds(copy):
            before = ask(show)
        stall.touch()
        for _ in range(2):
            os.kill(show.server(), signal.SIGKILL)
            show.heard("does not answer: the show goes on from memory")
            after = ask(show, SetChannel("one", "jawOpen", 0.25), above=before.epoch)
            assert after.characters["one"].faces == {"cousin": 1.0}
            assert after.characters["one"].channels.keys() == {"jawOpen"}
            before = after
        stall.unlink()
        show.heard("answers again: the show's process starts anew with it")
        after = ask(show, above=before.epoch)
        assert after.characters["one"].channels == {"jawOpen": 0.25}
        assert after.characters["one"].faces == {"cousin": 1.0}
        assert isinstance(asyncio.run(asyncio.wait_for(author(show.url, "Aunt"), LIMIT)), editing.Saved)
    assert list(copy.parent.glob(f"{copy.stem}*")) == []


def holds(copy: Path) -> bool:
    """Whether the copy of a show in memory has an own face."""
    with contextlib.suppress(OSError, ShowFileError):
        return [item.name for item in inspect_show(copy).stored.items] == ["cousin"]
    return False


def journalled(show: Show, word: bytes, name: str = "a.omote") -> bool:
    """Whether the show file holds this word in its last state."""
    path = Path(show.process.args[-1]).with_name(name)  # type: ignore[index, arg-type]
    file = open_show(path)
    snapshot = file.journal().snapshot
    file.close()
    return word in (snapshot or b"")


@pytest.fixture
def impatient(tmp_path: Path) -> Iterator[Show]:
    """A show whose servers hang when they are silent for a second."""
    yield from played(Show(tmp_path / "a.omote", SYNTHETIC_HANG="1"))


def test_a_server_that_hangs_is_replaced(impatient: Show) -> None:
    show = impatient
    before = ask(show)
    hanging = show.server()
    os.kill(hanging, signal.SIGSTOP)
    show.heard("the server hangs; another one takes over")
    assert ask(show, above=before.epoch).number > 0
    assert "stopped answering at " in notices(show, 1)[0].text
    assert not Path(f"/proc/{hanging}").exists() or hanging not in children(show.standby())


def test_a_standby_that_dies_is_replaced_and_the_server_plays_on(show: Show) -> None:
    before = ask(show)
    os.kill(show.standby(), signal.SIGKILL)
    show.heard("the standby ended")
    after = ask(show)
    assert after.epoch == before.epoch
    assert after.number > before.number


def test_server_and_standby_that_are_killed_at_one_instant_are_replaced_by_a_spare(show: Show) -> None:
    """Twice: the spare that took their place has one of its own. Nothing is loaded anew, nothing is left at the end."""
    before = ask(show, SetChannel("one", "jawOpen", 0.5))
    while not journalled(show, b"jawOpen"):
        before = ask(show)
    standby, server, spare = show.standby(), show.server(), spare_of(show)
    for _ in range(2):
        for pid in (standby, server):
            os.kill(pid, signal.SIGKILL)
        show.heard("the standby ended; its spare takes its place")
        before = ask(show, above=before.epoch)
        assert before.characters["one"].channels == {"jawOpen": 0.5}
        assert children(show.process.pid) == []
        standby, server, spare = spare, server_of(spare), spare_of(show, spare)
    ends = [os.pidfd_open(pid) for pid in (standby, server, spare)]
    show.process.terminate()
    assert show.process.wait(LIMIT) == 0
    for end in ends:
        assert wait_readable(end)
        os.close(end)


def spare_of(show: Show, standby: int = 0) -> int:
    """The process id of the copy of the standby that waits, once it is there: no process of the show is its parent.

    standby: the process id of a standby that was a spare itself.
    """
    path = os.fsencode(str(show.process.args[-1]))  # type: ignore[index]
    while True:
        parents = dict(filter(None, (parent_of(entry, path) for entry in Path("/proc").iterdir())))
        spares = [pid for pid, parent in parents.items() if parent not in parents and pid != standby]
        if spares := [pid for pid in spares if pid != show.process.pid]:
            return spares[0]


def parent_of(entry: Path, word: bytes) -> tuple[int, int] | None:
    """A process and its parent by its folder in /proc, where its command line has a word."""
    with contextlib.suppress(OSError):
        if entry.name.isdigit() and word in (entry / "cmdline").read_bytes():
            return int(entry.name), int((entry / "stat").read_text().rpartition(")")[2].split()[1])
    return None


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_everything(show: Show, number: signal.Signals) -> None:
    processes = [show.standby(), show.server()]
    show.process.send_signal(number)
    assert show.process.wait(LIMIT) == 0
    assert [pid for pid in processes if Path(f"/proc/{pid}").exists()] == []


def test_nothing_outlives_a_killed_supervisor(show: Show) -> None:
    ends = [os.pidfd_open(pid) for pid in (show.standby(), show.server())]
    show.process.kill()
    show.process.wait(LIMIT)
    for end in ends:  # a process's descriptor is readable when it has ended
        assert wait_readable(end)
        os.close(end)


def wait_readable(descriptor: int) -> bool:
    """Waits for a descriptor."""
    return bool(select.select([descriptor], [], [], LIMIT)[0])


def test_a_state_that_kills_servers_is_left_behind(tmp_path: Path) -> None:
    path = tmp_path / "a.omote"
    file = open_show(path)
    file.write_journal(JournalEntry(1, 0.0, msgspec.msgpack.encode({"poison": True})))
    file.close()
    poisoned = Show(path, SYNTHETIC_POISON="1")
    assert ask(poisoned).characters["one"].faces == {"generic": 1.0}
    poisoned.process.terminate()
    assert poisoned.process.wait(LIMIT) == 0
    assert poisoned.process.stdout is not None
    poisoned.process.stdout.close()


@pytest.fixture
def signals() -> Iterator[None]:
    """Puts the handlers of the signals back that a supervisor takes."""
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)}
    yield
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.mark.usefixtures("signals")
@pytest.mark.parametrize(("status", "tries"), [(REJECTED, 1), (1, FAILURES), (0, FAILURES)])
def test_a_standby_that_never_gets_ready_ends_the_show_after_the_start_limit(
    tmp_path: Path, status: int, tries: int
) -> None:
    started = tmp_path / "started"
    said = list[str]()
    program = ("/bin/sh", "-c", f"echo started >> '{started}'; exit {status}")
    with listen_on("127.0.0.1", 0) as listening:
        lock = lock_show(tmp_path / "a.omote")
        supervisor = Supervisor(
            listening, lock, tmp_path / "a.omote", report=said.append, opened=pytest.fail, program=program
        )
        assert supervisor.run() == 1
        os.close(lock)
    assert started.read_text().splitlines() == ["started"] * tries
    # One that was rejected has told the terminal itself.
    assert said == (
        [] if status == REJECTED else [f"the show could not be started in {tries} tries; what went wrong stands above."]
    )


def test_a_server_that_other_programs_keep_from_the_processors_does_not_hang(monkeypatch: pytest.MonkeyPatch) -> None:
    waited = 0.0
    monkeypatch.setattr(supervisor, "waiting_seconds", lambda _: waited)
    server = Server(control=-1, pulse=-1, pid=1, playing=True)
    server.hear(100.0)
    waited = 3.0
    assert not server.hangs(103.0 + 0.9 * HANG_SECONDS), "so much it has had of its own"
    assert server.hangs(103.0 + 1.1 * HANG_SECONDS)
    server.hear(104.1)
    assert server.hangs(104.1 + 1.1 * HANG_SECONDS), "what it waited before it was heard counts no more"


def test_starved_threads_and_a_starved_supervisor_excuse_a_silence_but_not_for_ever(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Another thread may hold what the main one needs; a server that hangs is found on a starved machine too."""
    locked = 10.0
    monkeypatch.setattr(supervisor, "waiting_seconds", lambda _: 0.0)
    monkeypatch.setattr(supervisor, "others_waiting_seconds", lambda _: locked)
    server = Server(control=-1, pulse=-1, pid=1, playing=True)
    server.hear(100.0)
    locked += 0.6
    server.late += 0.5
    assert not server.hangs(101.1 + 0.9 * HANG_SECONDS)
    assert server.hangs(101.1 + 1.1 * HANG_SECONDS)
    locked += 100.0
    assert not server.hangs(100.0 + LONGEST_EXCUSE + 0.9 * HANG_SECONDS)
    assert server.hangs(100.0 + LONGEST_EXCUSE + 1.1 * HANG_SECONDS)
    locked = 0.0  # threads have ended
    assert not server.hangs(100.5 + 0.9 * HANG_SECONDS)
    assert server.hangs(100.5 + 1.1 * HANG_SECONDS)
