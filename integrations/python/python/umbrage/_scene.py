"""Scenes that are held in memory: from arrays, or from the bytes of a file."""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy

from . import _umbrage

# glTF 2.0: what an accessor's components are, and what a buffer view holds.
_FLOAT, _UNSIGNED_INT = 5126, 5125
_ARRAY_BUFFER, _ELEMENT_ARRAY_BUFFER = 34962, 34963


class Scene:
    """A world in memory, for :func:`umbrage.plan`, :func:`umbrage.measure` and :func:`umbrage.pictures`.

    Where it comes without a camera or a light, it gets one that shows all of it, and a sun.
    """

    def __init__(self, held: _umbrage.Scene) -> None:
        self._held = held

    @classmethod
    def from_glb(cls, glb: bytes, name: str = "scene") -> Scene:
        """Reads a binary glTF file that is held in memory."""
        return cls(_umbrage.Scene.from_glb(bytes(glb), name))

    @classmethod
    def from_mesh(cls, positions: Any, indices: Any, name: str = "mesh") -> Scene:
        """Makes a scene of one mesh: ``positions`` is n × 3 numbers, metres, Y up; ``indices`` m × 3 whole numbers below n,
        a triangle a row, counter-clockwise seen from its front."""
        positions, indices = _positions(positions), _indices(indices)
        if indices.size and int(indices.max()) >= len(positions):
            raise ValueError(f"indices must be below {len(positions)}, the number of positions, got {int(indices.max())}")
        return cls.from_glb(_glb(positions, indices.astype("<u4"), name), name)

    @property
    def triangles(self) -> int:
        """The number of triangles."""
        return self._held.triangles

    @property
    def cameras(self) -> list[str]:
        """The names of the cameras."""
        return self._held.cameras

    @property
    def warnings(self) -> list[str]:
        """What was left out of the file, and why."""
        return self._held.warnings


def _positions(given: Any) -> numpy.ndarray:
    array = numpy.asarray(given)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"positions must be numbers, got {array.dtype}: convert them with .astype(numpy.float32)")
    _check_rows("positions", array)
    if not numpy.isfinite(array).all():
        row = int(numpy.argwhere(~numpy.isfinite(array))[0][0])
        raise ValueError(f"positions must be finite, got {array[row].tolist()} in row {row}")
    return array.astype("<f4")


def _indices(given: Any) -> numpy.ndarray:
    array = numpy.asarray(given)
    if array.dtype.kind not in "iu":
        raise TypeError(f"indices must be whole numbers, got {array.dtype}: convert them with .astype(numpy.uint32)")
    _check_rows("indices", array)
    if array.size and int(array.min()) < 0:
        raise ValueError(f"indices must be 0 or more, got {int(array.min())}")
    return array


def _check_rows(what: str, array: numpy.ndarray) -> None:
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{what} must be of shape (n, 3), got {array.shape}: reshape them with .reshape(-1, 3)")


def _glb(positions: numpy.ndarray, indices: numpy.ndarray, name: str) -> bytes:
    """The mesh as a binary glTF file: a header, the JSON, the numbers."""
    numbers, places = indices.tobytes(), positions.tobytes()
    low, high = (positions.min(axis=0), positions.max(axis=0)) if len(positions) else (numpy.zeros(3), numpy.zeros(3))
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name}],
        "meshes": [{"name": name, "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": _FLOAT, "count": len(positions), "type": "VEC3",
             "min": low.tolist(), "max": high.tolist()},
            {"bufferView": 1, "componentType": _UNSIGNED_INT, "count": indices.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(places), "target": _ARRAY_BUFFER},
            {"buffer": 0, "byteOffset": len(places), "byteLength": len(numbers), "target": _ELEMENT_ARRAY_BUFFER},
        ],
        "buffers": [{"byteLength": len(places) + len(numbers)}],
    }  # fmt: skip
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary = places + numbers
    total = 12 + 8 + len(text) + 8 + len(binary)
    header = struct.pack("<4sII", b"glTF", 2, total)
    return header + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(binary), b"BIN\0") + binary
