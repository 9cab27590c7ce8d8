"""Experiments on a cluster of Ray: two workers on this machine."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

import pytest
import ray
import umbrage
import umbrage.ray
from conftest import left



def start() -> None:
    ray.init(num_cpus=2, include_dashboard=False, log_to_driver=False, logging_level="error")


@pytest.fixture(scope="module")
def cluster():
    start()
    yield
    ray.shutdown()


@pytest.fixture
def whole(experiment, tmp_path) -> Path:
    umbrage.report(experiment, tmp_path / "whole")
    return tmp_path / "whole"


def test_a_cluster_makes_the_page_of_one_process(cluster, experiment, whole, tmp_path):
    rows = umbrage.ray.report(experiment, tmp_path / "out", shards=3)
    assert len(rows) == 8
    assert left(tmp_path / "out") == left(whole)


def processes(words: str) -> list[int]:
    """Those that are so called. Ray gives its workers the names of their tasks."""
    found = []
    for process in Path("/proc").iterdir():
        try:
            if process.name.isdigit() and words in (process / "cmdline").read_text():
                found.append(int(process.name))
        except OSError:
            pass  # It has ended meanwhile.
    return found


def own(process: int) -> bool:
    """Whether this process started it."""
    return f"PPid:\t{os.getpid()}\n" in Path(f"/proc/{process}/status").read_text()


def test_the_runs_of_a_worker_that_is_killed_are_done_again(cluster, experiment, tmp_path):
    experiment.write_text(experiment.read_text().replace("repeats = 2", "repeats = 20"))
    umbrage.report(experiment, tmp_path / "whole")
    killed = []

    def kill():
        while not killed:
            for worker in processes("umbrage shard")[:1]:
                time.sleep(0.3)
                os.kill(worker, signal.SIGKILL)
                killed.append(worker)

    killing = threading.Thread(target=kill)
    killing.start()
    umbrage.ray.report(experiment, tmp_path / "out", shards=2)
    killing.join()
    assert killed[0] not in processes("umbrage shard")
    assert left(tmp_path / "out") == left(tmp_path / "whole")


def test_what_is_wrong_with_an_experiment_is_said_in_the_same_words(cluster, experiment, tmp_path):
    experiment.write_text(experiment.read_text().replace('"close"', '"closer"'))
    with pytest.raises(ValueError, match="line 4, `cameras`.*closer"):
        umbrage.ray.report(experiment, tmp_path / "out", shards=2)


def test_a_sweep_that_was_cut_off_goes_on(cluster, experiment, whole, tmp_path):
    umbrage.ray.report(experiment, tmp_path / "out", shards=2)
    shard = tmp_path / "out" / "shards" / "1-of-2" / "runs"
    kept, lost, *_ = sorted(shard.glob("*.json"))
    lost.unlink()
    before = kept.read_bytes()
    umbrage.ray.report(experiment, tmp_path / "out", shards=2)
    assert lost.is_file() and kept.read_bytes() == before
    assert left(tmp_path / "out") == left(whole)


def test_a_cluster_that_is_gone_is_one_line_with_what_to_do_and_a_new_one_goes_on(experiment, tmp_path):
    ray.shutdown()
    start()
    experiment.write_text(experiment.read_text().replace("repeats = 2", "repeats = 20"))
    umbrage.report(experiment, tmp_path / "whole")
    results = tmp_path / "out" / "shards"

    def kill():
        while not list(results.glob("*/runs/*.json")):
            time.sleep(0.01)
        for head in filter(own, processes("gcs_server")):
            os.kill(head, signal.SIGKILL)

    killing = threading.Thread(target=kill)
    killing.start()
    with pytest.raises(RuntimeError) as why:
        umbrage.ray.report(experiment, tmp_path / "out", shards=20)
    killing.join()
    assert "cluster is gone" in str(why.value) and "`ray start --head`" in str(why.value) and "\n" not in str(why.value)
    start()
    umbrage.ray.report(experiment, tmp_path / "out", shards=20)
    assert left(tmp_path / "out") == left(tmp_path / "whole")


def test_a_cluster_that_is_not_there_is_one_line_with_what_to_do(experiment, tmp_path):
    ray.shutdown()
    with pytest.raises(ConnectionError) as why:
        umbrage.ray.report(experiment, tmp_path / "out", address="127.0.0.1:1")
    assert "`ray start --head`" in str(why.value) and "\n" not in str(why.value)
