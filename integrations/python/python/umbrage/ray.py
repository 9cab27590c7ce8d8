"""Experiments on a cluster: shards of a report as tasks of Ray (https://ray.io).

Every machine of the cluster needs this very build of umbrage, and an adapter that draws. Results are known by what they were
made of, so a task that is lost is done again elsewhere, and a sweep that was cut off goes on where it stopped.
"""

from __future__ import annotations

import os
import socket
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import umbrage

if TYPE_CHECKING:
    import pandas

__all__ = ["report"]

# A worker that is lost takes no more than its own shard with it; a machine that kills every worker is not asked for ever.
_RETRIES = 5
# As many shards a processor: the last ones to be done keep few waiting.
_SHARDS_A_CORE = 4
_PATIENCE_SECONDS = 5


def report(
    experiment: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    shards: int | None = None,
    adapter: str | None = None,
    address: str | None = None,
    **resources: Any,
) -> pandas.DataFrame | list[dict[str, Any]]:
    """Runs an experiment on a Ray cluster into the folder ``output``, and returns its rows as :func:`umbrage.report` does.

    ``shards`` is how many tasks there are: four for each processor of the cluster by default. ``address`` is the cluster's,
    where Ray is not initialised yet; without it Ray looks for one, and starts one here where there is none. ``resources`` are
    those of a task, as ``num_gpus=1``. Worlds that are files must be at the same path on every machine.
    """
    ray = _ray()
    if not ray.is_initialized():
        _connect(ray, address)
    kept = Path(output) / "shards"
    text = Path(experiment).read_bytes()
    try:
        count = shards or max(1, int(_SHARDS_A_CORE * ray.cluster_resources().get("CPU", 1)))
        task = ray.remote(max_retries=_RETRIES, **resources)(_measured)
        folders = [kept / f"{index}-of-{count}" for index in range(1, count + 1)]
        waiting = {
            task.options(name=f"umbrage shard {index}/{count}").remote(
                text, Path(experiment).name, index, count, adapter, _files(folder)
            ): folder
            for index, folder in enumerate(folders, 1)
        }
        while waiting:
            done, _ = ray.wait(list(waiting), timeout=_PATIENCE_SECONDS)
            # Ray ends the whole program a minute after its head is gone, so that is asked before.
            _knock(ray.get_runtime_context().gcs_address)
            for task in done:
                _keep(ray.get(task), waiting.pop(task))
    except ray.exceptions.RayTaskError as why:
        # What went wrong in a task goes wrong here in the same words.
        raise why.cause from None
    except (ray.exceptions.RayError, ConnectionError) as why:
        ray.shutdown()
        raise RuntimeError(
            f"the Ray cluster is gone, or has lost a task {_RETRIES} times ({_line(why)}): start it again with `ray start "
            f"--head` and call this again; what was measured is kept in {kept}"
        ) from None
    return umbrage.report(experiment, output, merge=folders, adapter=adapter)


def _ray() -> Any:
    try:
        import ray
    except ImportError:
        raise ImportError("umbrage.ray needs Ray: `pip install ray`") from None
    return ray


def _connect(ray: Any, address: str | None) -> None:
    try:
        if address and ":" in address:
            _knock(address.removeprefix("ray://"))  # Ray itself would try for minutes.
        ray.init(address=address, log_to_driver=False)
    except (ConnectionError, RuntimeError, ValueError) as why:
        raise ConnectionError(
            f"no Ray cluster answers at {address or 'any address'} ({_line(why)}): start one with `ray start --head`, or leave "
            "`address` out to start one on this machine"
        ) from None


def _knock(address: str) -> None:
    """Fails where nobody listens at host:port."""
    host, _, port = address.rpartition(":")
    try:
        socket.create_connection((host, int(port)), _PATIENCE_SECONDS).close()
    except OSError as why:
        raise ConnectionError(f"{address}: {_line(why)}") from None


def _measured(
    text: bytes, name: str, index: int, count: int, adapter: str | None, known: dict[str, bytes]
) -> dict[str, bytes]:
    """What a task does: it measures a shard, but for what is known already, and returns the files of all its results."""
    with tempfile.TemporaryDirectory() as folder:
        experiment, output = Path(folder) / name, Path(folder) / "output"
        experiment.write_bytes(text)
        _keep(known, output)
        umbrage.report(experiment, output, shard=(index, count), adapter=adapter)
        return _files(output)


def _files(folder: Path) -> dict[str, bytes]:
    """The results that lie in a folder, by their names."""
    return {path.name: path.read_bytes() for path in (folder / "runs").glob("*") if path.is_file()}


def _keep(files: dict[str, bytes], folder: Path) -> None:
    """Writes results into a folder. One that is cut off is no result: it does not fit its checksum."""
    (folder / "runs").mkdir(parents=True, exist_ok=True)
    for name, content in files.items():
        (folder / "runs" / name).write_bytes(content)


def _line(why: BaseException) -> str:
    """The first line of an error."""
    return (str(why).strip().splitlines() or [type(why).__name__])[0]
