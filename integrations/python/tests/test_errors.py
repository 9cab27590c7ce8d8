"""What cannot be done is said in one line, as an exception of Python's own."""

from __future__ import annotations

import _thread
import threading
import time

import pytest
import umbrage


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"size": (0, 5)}, "at least one pixel each way, got 0 x 5"),
        ({"camera": "nowhere"}, "no camera `nowhere`; there are 0 (main)"),
        ({"settings": {"splitz": 3}}, "splitz"),
        ({"settings": {"splits": 0}}, "`splits` must be from 1 to 9, got 0"),
        ({"settings": {"lambda": float("nan")}}, "finite"),
        ({"preset": "bevie"}, "no preset is called `bevie`"),
        ({"sun": (0, 0, 0)}, "direction"),
        ({"sun": (0, 1)}, "wanted three numbers"),
        ({"fov": "wide"}, "--fov"),
        ({"light": [99]}, "no light `99`"),
    ],
)
def test_wrong_options_are_value_errors_of_one_line(options, words):
    with pytest.raises(ValueError) as why:
        umbrage.plan("primitives", **options)
    assert words in str(why.value) and "\n" not in str(why.value)


def test_options_that_there_are_not_and_worlds_that_are_none_are_type_errors():
    with pytest.raises(TypeError, match="no option `splits`; there are animation, camera"):
        umbrage.plan("primitives", splits=3)
    with pytest.raises(TypeError, match="a name, a path or an umbrage.Scene, got int"):
        umbrage.plan(3)
    with pytest.raises(ValueError, match="no built-in world is called `atlantis`"):
        umbrage.plan("atlantis")
    with pytest.raises(ValueError, match="no built-in world is called `--version`"):
        umbrage.plan("--version")


def test_work_that_fails_is_a_runtime_error(tmp_path):
    (tmp_path / "bad.glb").write_bytes(b"not one")
    with pytest.raises(RuntimeError, match="bad.glb"):
        umbrage.plan(tmp_path / "bad.glb")
    with pytest.raises(RuntimeError, match="no pixels to judge"):
        umbrage.measure("primitives", eye=(0, 500, 0), target=(0, 600, 0), size=(16, 9), frames=0)


def test_python_goes_on_while_it_is_measured():
    ticks = []
    is_done = threading.Event()

    def tick():
        while not is_done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.01)

    ticking = threading.Thread(target=tick)
    ticking.start()
    start = time.monotonic()
    umbrage.measure("primitives", size=(320, 180), frames=20)
    end = time.monotonic()
    is_done.set()
    ticking.join()
    during = [tick for tick in ticks if start < tick < end]
    assert len(during) > 0.2 * (end - start) / 0.01, f"{len(during)} ticks in {end - start} s"


def test_a_report_is_interrupted_between_two_runs_and_goes_on_later(experiment, tmp_path):
    experiment.write_text(experiment.read_text().replace("repeats = 2", "repeats = 500"))
    output = tmp_path / "out"

    def interrupt():
        while not list(output.glob("runs/*.json")):
            time.sleep(0.01)
        _thread.interrupt_main()

    watching = threading.Thread(target=interrupt)
    watching.start()
    with pytest.raises(KeyboardInterrupt):
        umbrage.report(experiment, output)
    watching.join()
    assert 1 <= len(list(output.glob("runs/*.json"))) < 2000
    experiment.write_text(experiment.read_text().replace("repeats = 500", "repeats = 1"))
    assert len(umbrage.report(experiment, output)) == 4
