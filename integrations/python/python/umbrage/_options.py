"""Options of Python as words of the command line."""

from __future__ import annotations

import json
import os
from typing import Any, Literal, Mapping, Sequence, TypedDict, Union

Point = Sequence[float]
Settings = Union[Mapping[str, Any], str, "os.PathLike[str]"]


class ShadowOptions(TypedDict, total=False):
    """How shadows are made."""

    preset: str
    """Named settings to start from; ``default`` by default."""
    settings: Settings
    """Settings over that: a dictionary, as ``{"splits": 3, "filter": {"kind": "pcf"}}``, or the path of a TOML file."""


class PlanOptions(ShadowOptions, total=False):
    """What is seen, from where, lit how."""

    camera: str | int
    """One of the world's cameras, by name or by number from 0; the first by default."""
    eye: Point
    """Where the camera stands, metres; goes with ``target``."""
    target: Point
    """What the camera looks at, metres."""
    fov: float
    """Whole vertical field of view, degrees."""
    near: float
    """Nearest visible depth, metres."""
    far: float
    """Farthest visible depth, metres."""
    sun: Point
    """The way sunlight travels: a sun instead of the world's lights."""
    light: Sequence[str | int]
    """The world's lights that shine, by name or by number from 0; the brightest 16 by default."""
    near_light: float
    """Nearer to a lamp than this nothing casts a shadow, metres."""
    no_cast: Sequence[str]
    """Names of nodes, meshes and materials that cast no shadow."""
    cast: Sequence[str]
    """Names of those that do although the world says otherwise."""
    size: tuple[int, int]
    """Width and height of the picture, pixels."""
    time: float
    """When, for things that move, seconds."""
    animation: str | int
    """Which of the file's animations plays, by name or by number from 0, or ``"none"``."""
    day: float
    """Suns go once around in so many seconds."""
    seed: int
    """What a built-in world is grown from."""


class PicturesOptions(PlanOptions, total=False):
    """The same, and what visibility is compared with."""

    adapter: str
    """Part of the name of the adapter that draws."""
    truth: Literal["hard", "sub-pixel", "soft"]
    """What is true: one ray through each pixel, the mean over each pixel, or over points of the light."""
    sun_points: int
    """Points of each light that a soft truth is the mean of."""
    sun_angle: float
    """The angle that the sun is seen under, for a soft truth, degrees."""
    family: str
    """Another family of shadows than maps, as ``"volumes"`` or ``'{ kind = "plateaus", degrees = 2.0 }'``."""


class MeasureOptions(PicturesOptions, total=False):
    """The same, and what else is measured."""

    repeats: int
    """Measure from so many cameras, moved a little."""
    frames: int
    """Frames that are timed; 10 by default."""
    motion: str
    """A path along which it is measured how unsteady shadows are, as ``"yaw"``."""


class WgslOptions(ShadowOptions, total=False):
    """Which shader."""

    stage: str
    """Which text; ``receiver`` by default."""
    group: int
    """The group of its bindings."""
    textures: Literal["webgpu", "all"]
    """What the device can do that runs it."""


def words(known: type | None, options: Mapping[str, Any], *first: str) -> list[str]:
    """The words that say the same. Options that are ``None`` say nothing."""
    given = {name: value for name, value in options.items() if value is not None}
    if known is not None:
        names = known.__annotations__
        for name in given:
            if name not in names:
                raise TypeError(f"there is no option `{name}`; there are {', '.join(sorted(names))}")
    # A path may begin with a dash; what comes after `--` is no option.
    return [word for name, value in given.items() for word in _of(name, value)] + (["--", *first] if first else [])


def _of(name: str, value: Any) -> list[str]:
    flag = "--" + name.replace("_", "-")
    if name == "settings":
        return [f"--set={key}={_toml(value)}" for key, value in _flat(value)] if isinstance(value, Mapping) else [
            f"--shadows={os.fspath(value)}"
        ]
    if name == "size":
        return [f"{flag}={'x'.join(str(side) for side in value)}"]
    if name in ("eye", "target", "sun"):
        return [f"{flag}={','.join(repr(float(number)) for number in value)}"]
    if name in ("light", "cast", "no_cast", "merge"):
        values = [value] if isinstance(value, (str, int)) else value
        return [f"{flag}={each}" for each in values]
    return [f"{flag}={os.fspath(value) if isinstance(value, os.PathLike) else value}"]


def _flat(table: Mapping[str, Any], before: str = "") -> list[tuple[str, Any]]:
    """Tables within tables as keys with dots."""
    pairs: list[tuple[str, Any]] = []
    # A kind decides which other keys its table has, so it comes first.
    for key, value in sorted(table.items(), key=lambda pair: pair[0] != "kind"):
        pairs += _flat(value, f"{before}{key}.") if isinstance(value, Mapping) else [(before + key, value)]
    return pairs


def _toml(value: Any) -> str:
    """A value as TOML writes it, which is as JSON does where it is a number, a text, a truth value or a list of them."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    try:
        return json.dumps(value, allow_nan=False)
    except (TypeError, ValueError):
        raise ValueError(f"a setting is a finite number, a text, True, False or a list of them, got {value!r}") from None
