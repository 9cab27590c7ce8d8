"""Scenes from arrays: what is seen of them, and what is refused."""

from __future__ import annotations

import numpy
import pytest
import umbrage

# A plate over a ground, each two triangles.
PLATE = numpy.array([[-1, 2, -1], [1, 2, -1], [1, 2, 1], [-1, 2, 1]])
GROUND = numpy.array([[-5, 0, -5], [5, 0, -5], [5, 0, 5], [-5, 0, 5]])
SQUARE = numpy.array([[0, 2, 1], [0, 3, 2]])


def plate_over_ground() -> umbrage.Scene:
    return umbrage.Scene.from_mesh(numpy.vstack([PLATE, GROUND]), numpy.vstack([SQUARE, SQUARE + 4]))


def test_a_plate_shadows_the_ground_below_it():
    scene = plate_over_ground()
    assert (scene.triangles, scene.warnings) == (4, [])
    # Straight down: the shadow is the plate's size, 4 m² of the ground's 100.
    down = dict(sun=(0, -1, 0), eye=(0, 1, 9), target=(0, 0, 0), far=100, size=(96, 54))
    measured = umbrage.measure(scene, frames=0, **down)
    assert measured["triangles"] == 4 and measured["truth"]["shadowed"] > 0
    assert measured["error"]["mis_shadowed"] < 0.05
    seen = umbrage.pictures(scene, **down)
    assert (seen.truth == 0).sum() == measured["truth"]["shadowed"]
    assert umbrage.plan(scene, **down)["world"] == measured["world"]


@pytest.mark.parametrize("dtype", ["float64", "float32", "int16"])
def test_positions_may_be_any_numbers(dtype):
    scene = umbrage.Scene.from_mesh(GROUND.astype(dtype), SQUARE.astype("uint8"))
    assert scene.triangles == 2 and len(scene.cameras) == 1


@pytest.mark.parametrize(
    ("positions", "indices", "wrong", "words"),
    [
        (GROUND.ravel(), SQUARE, ValueError, "positions must be of shape (n, 3), got (12,): reshape them"),
        (GROUND[:, :2], SQUARE, ValueError, "positions must be of shape (n, 3), got (4, 2)"),
        (GROUND.astype(str), SQUARE, TypeError, "positions must be numbers, got <U"),
        (GROUND * [1, numpy.nan, 1], SQUARE, ValueError, "positions must be finite, got [-5.0, nan, -5.0] in row 0"),
        (GROUND, SQUARE.ravel(), ValueError, "indices must be of shape (n, 3), got (6,)"),
        (GROUND, SQUARE.astype(float), TypeError, "indices must be whole numbers, got float64: convert them"),
        (GROUND, SQUARE - 1, ValueError, "indices must be 0 or more, got -1"),
        (GROUND, SQUARE + 1, ValueError, "indices must be below 4, the number of positions, got 4"),
        (GROUND, numpy.zeros((0, 3), int), ValueError, "no triangles"),
        (numpy.zeros((0, 3)), numpy.zeros((0, 3), int), ValueError, "triangle"),
    ],
)
def test_arrays_that_make_no_scene_are_refused_with_what_to_do(positions, indices, wrong, words):
    with pytest.raises(wrong) as why:
        umbrage.Scene.from_mesh(positions, indices)
    assert words in str(why.value) and "\n" not in str(why.value)


def test_bytes_that_are_no_file_are_refused():
    with pytest.raises(ValueError, match="glTF|glb|GLB"):
        umbrage.Scene.from_glb(b"not one")
