"""Exports on a cluster of Dask: the same bytes as here; another Omote, a missing one and no cluster are told."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from distributed import LocalCluster

from omote.interchange.exports import export_formats
from omote.server.farm import dask_pool
from omote.server.farm.dask_pool import bake_on_cluster, check_workers, describe_omote
from omote.server.farm.export_run import run_export
from tests import synthetic
from tests.server.farm.runs import contents, ignore, make_run, pool_here
from tests.stage_data.heads import context

FACES = list(synthetic.FACES)


@pytest.fixture
def small_cast(monkeypatch: pytest.MonkeyPatch) -> None:
    """The synthetic cast in place of the built-in one, here and on workers that are threads of this process."""
    monkeypatch.setattr("omote.builtin.load_cast", lambda: context().cast)
    monkeypatch.setattr("omote.builtin.load_meshes", lambda: context().meshes)
    monkeypatch.setattr("omote.builtin.load_mask", lambda: context().layers)
    dask_pool._context.cache_clear()


@pytest.fixture
def cluster() -> Iterator[Any]:
    """Two workers in threads of this process."""
    local: Any = LocalCluster  # it ships no types
    with local(n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None, protocol="tcp") as made:
        yield made


@pytest.mark.usefixtures("small_cast")
def test_a_cluster_bakes_the_same_bytes(tmp_path: Path, cluster: Any) -> None:
    away = run_export(make_run(tmp_path / "a", kind=".glb"), bake_on_cluster(cluster.scheduler_address), ignore)
    run_export(make_run(tmp_path / "b", kind=".glb"), pool_here, ignore)
    assert sorted(away.exported) == sorted(FACES)
    assert contents(tmp_path / "a") == contents(tmp_path / "b")
    again = run_export(make_run(tmp_path / "a", kind=".glb"), bake_on_cluster(cluster.scheduler_address), ignore)
    assert (again.exported, sorted(again.current)) == ([], sorted(FACES))


@pytest.mark.usefixtures("small_cast")
def test_a_face_that_fails_there_is_named(tmp_path: Path, cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    real = export_formats.bake_face

    def bake(context: Any, face: str, *rest: Any, **more: Any) -> Any:
        if face == FACES[0]:
            raise ValueError("this face does not fit")
        return real(context, face, *rest, **more)

    monkeypatch.setattr(dask_pool, "bake_face", bake)
    done = run_export(make_run(tmp_path), bake_on_cluster(cluster.scheduler_address), ignore)
    assert (sorted(done.exported), done.failed) == (sorted(FACES[1:]), {FACES[0]: "this face does not fit"})


@pytest.mark.usefixtures("small_cast")
def test_a_worker_with_another_omote_is_told(tmp_path: Path, cluster: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dask_pool, "check_workers", lambda _: None)  # a worker that comes later is not asked before
    order = dask_pool._order
    monkeypatch.setattr(dask_pool, "_order", lambda run, number, _: order(run, number, "0.0.1 with cast abc"))
    with pytest.raises(OSError, match=r"a worker has Omote .*, this machine 0\.0\.1 with cast abc; install the same"):
        run_export(make_run(tmp_path), bake_on_cluster(cluster.scheduler_address), ignore)


class FalseClient:
    """A client whose workers say what they are given to say."""

    def __init__(self, said: dict[str, object]) -> None:
        self.said = said

    def run(self, _: Any, on_error: str) -> dict[str, object]:
        assert on_error == "return"
        return self.said


@pytest.mark.usefixtures("small_cast")
def test_workers_are_asked_before_anything_is_sent() -> None:
    check_workers(FalseClient({"tcp://one:1": describe_omote()}))
    with pytest.raises(ValueError, match=r"worker tcp://one:1 has Omote 0\.0\.1, this machine .*; install the same"):
        check_workers(FalseClient({"tcp://one:1": "0.0.1"}))
    with pytest.raises(ValueError, match=r"cannot load Omote \(ModuleNotFoundError: .*\); install"):
        check_workers(FalseClient({"tcp://one:1": ModuleNotFoundError("No module named 'omote'")}))
    with pytest.raises(OSError, match="this cluster has no workers"):
        check_workers(FalseClient({}))


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nonsense", "8786"])
def test_no_cluster_is_a_sentence(tmp_path: Path, address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(dask_pool, "TIMEOUT", 0.2)
    with pytest.raises(OSError, match="no Dask scheduler answers at"):
        run_export(make_run(tmp_path), bake_on_cluster(address), ignore)
