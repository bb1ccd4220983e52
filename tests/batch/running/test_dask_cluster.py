"""A real cluster of two workers on this machine, one of which is killed: only the job that kills its worker is lost."""

import os
import shutil
import signal
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest

from understudy.batch.audio import AudioSource
from understudy.batch.running.dask_cluster import DaskEngine
from understudy.batch.running.engine import WORKER_DIED, Done, supervise
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import LineJob, LineOutcome, OutputTarget
from understudy.errors import InputError
from understudy.options import Options
from understudy.settings import Settings

distributed = pytest.importorskip("distributed", reason="the extra `cluster` is not installed")

AUDIO = Path(__file__).parents[2] / "audio"
KILLER = 5

pytestmark = pytest.mark.filterwarnings("ignore")


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """The scheduler gives a task up at its first death, so that the tests need not wait for three more."""
    import dask

    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
    ):
        yield cluster.scheduler_address


def test_lines_are_sent_and_files_sent_back_though_a_worker_is_killed(address: str, tmp_path: Path) -> None:
    recording = tmp_path / "one.flac"
    shutil.copy(AUDIO / "figure8.flac", recording)
    text = (AUDIO / "figure8.txt").read_text(encoding="utf-8")
    jobs = [
        LineJob(
            f"l{number}", text, AudioSource(recording), Options(), (OutputTarget(LineFormat.BML, f"l{number}.bml"),)
        )
        for number in range(6)
    ]
    with closing(DaskEngine(address, Settings(), shares_files=False)) as engine:
        assert engine.places == 2
        victim = engine.call(os.getpid).result()
        found: list[Done[LineJob, LineOutcome]] = []
        for done in supervise(jobs, engine.submit, places=engine.places):
            if not found:
                os.kill(victim, signal.SIGKILL)
            found.append(done)
    assert sorted(done.job.id for done in found) == [job.id for job in jobs]
    assert not [done.failure for done in found if done.failure]
    assert len({done.result.files[0].content for done in found if done.result}) == 1
    assert not (tmp_path / "l0.bml").exists()


def test_a_killing_job_fails_alone(address: str) -> None:
    with closing(DaskEngine(address, Settings(), shares_files=True)) as engine:
        done = list(supervise(range(12), lambda number: engine.call(_square, number), places=2))
    assert [(each.job, each.failure) for each in done if each.failure] == [(KILLER, WORKER_DIED)]
    assert sorted(each.result for each in done if each.result is not None) == [
        number**2 for number in range(12) if number != KILLER
    ]


def test_no_scheduler_is_told() -> None:
    with pytest.raises(InputError) as raised:
        DaskEngine("nowhere", Settings(), shares_files=True)
    assert raised.value.code == "cluster_unreachable"


def _square(number: int) -> int:
    if number == KILLER:
        os.kill(os.getpid(), signal.SIGKILL)
    return number * number
