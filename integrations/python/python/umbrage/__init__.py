"""Real-time shadows for large worlds: planned, drawn, and measured against exact ones.

A world is the name of a built-in one (see :func:`worlds`), the path of a ``.glb``, ``.gltf`` or ``.obj``, or a
:class:`Scene`. Options have the names that the command ``umbrage`` gives them, with ``_`` for ``-``: what
``umbrage measure bunny --size 160x90 --set splits=3`` prints, ``umbrage.measure("bunny", size=(160, 90),
settings={"splits": 3})`` returns. Wrong options are a :class:`ValueError`, work that fails a :class:`RuntimeError`.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Sequence, Union

import numpy

from . import _umbrage
from ._options import MeasureOptions, PicturesOptions, PlanOptions, WgslOptions, words
from ._rows import rows_of
from ._scene import Scene

if TYPE_CHECKING:
    import pandas
    from numpy.typing import NDArray
    from typing_extensions import Unpack

__version__: str = _umbrage.__version__
__all__ = ["Pictures", "Scene", "measure", "pictures", "plan", "report", "settings", "wgsl", "worlds"]

World = Union[str, "os.PathLike[str]", Scene]
"""A built-in world's name, a file's path, or a scene."""


def plan(world: World, **options: Unpack[PlanOptions]) -> dict[str, Any]:
    """Returns where a camera's depth is cut and the views it makes, as ``umbrage plan --json`` does. Needs no GPU."""
    name, scene = _world(world)
    return json.loads(_umbrage.plan(words(PlanOptions, options, name), scene))


def measure(world: World, **options: Unpack[MeasureOptions]) -> dict[str, Any]:
    """Returns how wrong shadows are, against exact ones, and what they cost, as ``umbrage measure --json`` does."""
    name, scene = _world(world)
    return json.loads(_umbrage.measure(words(MeasureOptions, options, name), scene))


@dataclass(frozen=True)
class Pictures:
    """Visibility in three arrays of float32, each by light, row and column: 1 where lit, 0 where shadowed."""

    visibility: NDArray[numpy.float32]
    """What was drawn."""
    truth: NDArray[numpy.float32]
    """What is true; NaN where no pixel is judged: sky, and surfaces that face away from the light."""
    error: NDArray[numpy.float32]
    """The first less the second: above 0 where falsely lit, below 0 where falsely shadowed."""


def pictures(world: World, **options: Unpack[PicturesOptions]) -> Pictures:
    """Draws a world's shadows, and traces what is true of them."""
    name, scene = _world(world)
    shape, *numbers = _umbrage.pictures(words(PicturesOptions, options, name), scene)
    visibility, truth = (numpy.frombuffer(of, numpy.float32).reshape(shape) for of in numbers)
    return Pictures(visibility, truth, visibility - truth)


def report(
    experiment: str | os.PathLike[str],
    output: str | os.PathLike[str],
    *,
    shard: tuple[int, int] | None = None,
    merge: Sequence[str | os.PathLike[str]] = (),
    adapter: str | None = None,
) -> pandas.DataFrame | list[dict[str, Any]]:
    """Runs an experiment into the folder ``output``, where its page goes, and returns its rows.

    A row is a line of the CSV that lies there: a :class:`pandas.DataFrame` where pandas is installed, and otherwise a list of
    dictionaries. What is measured is kept, and never measured twice by the same build of this module. ``shard=(2, 8)``
    measures the second of eight shares of the runs and writes no page; ``merge`` takes results from folders that shards were
    written to, and measures nothing. Ctrl+C stops between two runs.
    """
    given = {"output": output, "merge": [os.fspath(folder) for folder in merge], "adapter": adapter}
    if shard is not None:
        given["shard"] = "/".join(str(number) for number in shard)
    return rows_of(_umbrage.report(words(None, given, os.fspath(experiment)), _umbrage.__file__))


def wgsl(**options: Unpack[WgslOptions]) -> str:
    """Returns a shader's text, for any WGSL compiler, as ``umbrage wgsl`` does."""
    return _umbrage.wgsl(words(WgslOptions, options))


def worlds() -> list[dict[str, Any]]:
    """Returns the built-in worlds, as ``umbrage worlds --json`` does: ``name``, ``summary``, ``source``, ``is_default``."""
    return json.loads(_umbrage.worlds())


def settings() -> list[dict[str, Any]]:
    """Returns every setting, as ``umbrage settings --json`` does: ``name``, ``help``, ``values``, ``default``, and so on."""
    return json.loads(_umbrage.settings())


def _world(world: World) -> tuple[str, _umbrage.Scene | None]:
    """The word for a world, and the scene itself where it is one."""
    if isinstance(world, Scene):
        return "scene", world._held
    if isinstance(world, (str, os.PathLike)):
        return os.fspath(world), None
    raise TypeError(f"a world is a name, a path or an umbrage.Scene, got {type(world).__name__}")
