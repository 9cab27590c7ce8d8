"""Arrays: their shapes, and that they are what was measured."""

from __future__ import annotations

import numpy
import pytest
import umbrage


def test_arrays_are_by_light_row_and_column():
    of_lamps = umbrage.pictures("night-chessboard", size=(96, 54), light=[0, 1, 2])
    for array in (of_lamps.visibility, of_lamps.truth, of_lamps.error):
        assert array.shape == (3, 54, 96) and array.dtype == numpy.float32


def test_their_error_is_the_measured_one():
    options = dict(size=(160, 90), settings={"resolution": 256})
    seen = umbrage.pictures("primitives", **options)
    judged = ~numpy.isnan(seen.truth)
    assert ((seen.visibility >= 0) & (seen.visibility <= 1)).all()
    assert set(numpy.unique(seen.truth[judged])) == {0, 1}
    measured = umbrage.measure("primitives", frames=0, **options)
    assert judged.sum() == measured["truth"]["pixels"]
    assert numpy.abs(seen.error[judged], dtype=float).mean() == pytest.approx(measured["error"]["mae"], rel=1e-6)
    # A pixel is wrong where it is on the other side of one half.
    wrong = (seen.visibility >= 0.5)[judged] != (seen.truth[judged] >= 0.5)
    assert wrong.mean() == pytest.approx(measured["error"]["mis_shadowed"], rel=1e-6)
    assert wrong.any()


def test_a_soft_truth_has_values_between():
    seen = umbrage.pictures("primitives", size=(64, 36), truth="soft", sun_points=16, sun_angle=5)
    truth = seen.truth[~numpy.isnan(seen.truth)]
    assert ((truth > 0) & (truth < 1)).any() and truth.min() >= 0 and truth.max() <= 1
