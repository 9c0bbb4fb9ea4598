"""Bakes faces on a Dask cluster: the same function as here, on workers with the same Omote; bytes come back.

Files come back and are written here, since workers need share no disk with this machine. A worker has the built-in
cast itself; what a show file adds is sent to each once.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import lru_cache
from typing import Any

import msgspec

from omote import __version__, builtin
from omote.interchange.avatar.vrm_licence import Credit
from omote.interchange.export_face import ExportContext
from omote.interchange.exports.export_formats import bake_face, check_kind
from omote.server.farm.export_run import ExportRun, MadeFiles, Pool
from omote.server.farm.fork_pool import WorkOutcome, try_work
from omote.server.farm.own_cast import pack_own, unpack_own

NEEDS_DASK = '--on wants the package distributed: pip install "omote[farm]", here and on every worker'
TIMEOUT = 10.0
"""Seconds to wait for a scheduler's answer."""
AHEAD = 2
"""Pieces of work for each thread of the cluster that are sent at once: results of more would only fill memory."""


class BakeOrder(msgspec.Struct, frozen=True):
    """A face to be baked elsewhere; omote: version and cast of who orders it."""

    number: int
    omote: str
    face: str
    expressions: list[str]
    kind: str
    stem: str
    hair: bool
    credit: Credit | None = None
    body: str = ""


def describe_omote() -> str:
    """The version of Omote here and the digest of its built-in cast: where both are the same, so is what is baked."""
    return f"{__version__} with cast {builtin.load_cast().digest}"


def bake_remotely(order: bytes, own: bytes) -> bytes:
    """Bakes an encoded `BakeOrder`; own: `pack_own` of the cast that it is of. Returns an encoded `WorkOutcome`.

    order: the encoded order.
    """
    wanted = msgspec.msgpack.decode(order, type=BakeOrder)
    if wanted.omote != (here := describe_omote()):
        failure = f"a worker has Omote {here}, this machine {wanted.omote}; install the same on both"
        return msgspec.msgpack.encode(WorkOutcome(wanted.number, failure=failure, final=True))

    def work(_: int) -> bytes:
        check_kind(wanted.kind, wanted.credit)
        named = wanted.face, wanted.expressions, wanted.kind, wanted.stem
        files = bake_face(_context(own), *named, hair=wanted.hair, credit=wanted.credit, body=wanted.body)
        return msgspec.msgpack.encode(MadeFiles(files))

    return msgspec.msgpack.encode(try_work(work, wanted.number))


@lru_cache(maxsize=2)
def _context(own: bytes) -> ExportContext:
    return ExportContext(unpack_own(builtin.load_cast(), own), builtin.load_meshes(), builtin.load_mask())


def bake_on_cluster(address: str) -> Pool:
    """A pool of a cluster's workers, by the address of its scheduler (tcp://host:8786).

    It raises ValueError where Dask is not installed here or Omote is not the same there, OSError where no scheduler
    answers or it has no workers.
    """

    def pool(run: ExportRun, numbers: Sequence[int]) -> Generator[WorkOutcome]:
        with open_cluster(address) as client:
            check_workers(client)
            own = client.scatter(pack_own(run.context.cast, builtin.load_cast()), broadcast=True)
            yield from _results(client, run, numbers, own)

    return pool


@contextmanager
def open_cluster(address: str) -> Iterator[Any]:
    """Connects to a cluster; errors as `bake_on_cluster`."""
    try:
        from distributed import Client
    except ImportError as error:
        raise ValueError(NEEDS_DASK) from error
    try:
        connect: Any = Client  # it ships no types for this
        client = connect(address, timeout=TIMEOUT, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise OSError(
            f"no Dask scheduler answers at {address!r}; start one there (dask scheduler), and workers with Omote "
            "(dask worker), and name it as tcp://HOST:8786"
        ) from error
    with client:
        yield client


def check_workers(client: Any) -> None:
    """Checks the workers of a cluster: OSError where it has none, ValueError where one has another Omote or none."""
    answers: Mapping[str, object] = client.run(describe_omote, on_error="return")
    if not answers:
        raise OSError("this cluster has no workers; start some: dask worker tcp://HOST:8786")
    here = describe_omote()
    for worker, said in answers.items():
        if isinstance(said, BaseException):
            raise ValueError(
                f"the worker {worker} cannot load Omote ({type(said).__name__}: {said}); install version {__version__} "
                "there"
            )
        if said != here:
            raise ValueError(f"the worker {worker} has Omote {said}, this machine {here}; install the same on both")


def _results(client: Any, run: ExportRun, numbers: Sequence[int], own: Any) -> Generator[WorkOutcome]:
    """The outcome of each piece of work as it comes; no more are under way than the cluster works at soon."""
    import distributed

    follow: Any = distributed.as_completed  # it ships no types
    waiting = list(numbers)
    here = describe_omote()
    under_way = follow(loop=client.loop)
    asked: dict[Any, int] = {}
    try:
        while waiting or asked:
            while waiting and len(asked) < AHEAD * max(1, sum(client.nthreads().values())):
                number = waiting.pop(0)
                future = client.submit(bake_remotely, _order(run, number, here), own, pure=False)
                asked[future] = number
                under_way.add(future)
            yield _outcome(future := next(under_way), asked.pop(future))
    finally:
        with suppress(Exception):  # the cluster may be what is gone
            client.cancel(list(asked))


def _outcome(future: Any, number: int) -> WorkOutcome:
    """What came of a piece of work; one whose workers died, or whose result was lost, has failed."""
    error = future.exception()
    if error is None:
        return msgspec.msgpack.decode(future.result(), type=WorkOutcome)
    return WorkOutcome(number, failure=f"the cluster could not do it ({type(error).__name__}: {error})")


def _order(run: ExportRun, number: int, here: str) -> bytes:
    face = run.faces[number]
    named = number, here, face, [*run.expressions], run.kind, run.stems[face]
    return msgspec.msgpack.encode(BakeOrder(*named, run.hair, run.credit, run.body))
