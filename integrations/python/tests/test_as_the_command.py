"""The module says what the command says."""

from __future__ import annotations

import umbrage
from conftest import command, command_json


def test_a_plan_is_the_commands():
    words = ["plan", "primitives", "--size", "320x180", "--set", "splits=3", "--set", "filter.kind=pcf", "--set", "filter.size=7"]
    plan = umbrage.plan("primitives", size=(320, 180), settings={"splits": 3, "filter": {"size": 7, "kind": "pcf"}})
    assert plan == command_json(*words)
    assert len(plan["views"]) == 3


def test_every_kind_of_option_is_the_commands():
    words = "plan primitives --eye 4,3,-9.5 --target 0,1,0 --fov 50 --near 0.25 --far 80 --sun=-0.5,-1,0.25 --preset soft --seed 7"
    placed = dict(eye=(4, 3, -9.5), target=[0, 1, 0], fov=50, near=0.25, far=80, sun=(-0.5, -1, 0.25), preset="soft", seed=7)
    assert umbrage.plan("primitives", **placed) == command_json(*words.split())
    lamps = ["plan", "night-chessboard", "--light", "0", "--light", "2", "--camera", "far", "--time", "1.5"]
    assert umbrage.plan("night-chessboard", light=[0, 2], camera="far", time=1.5) == command_json(*lamps)


def test_settings_may_lie_in_a_file(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("[shadows]\nsplits = 2\n")
    assert umbrage.plan("primitives", settings=path) == command_json("plan", "primitives", "--shadows", str(path))


def test_a_measurement_is_the_commands():
    measured = umbrage.measure("primitives", size=(160, 90), frames=0)
    assert measured == command_json("measure", "primitives", "--size", "160x90", "--frames", "0")
    timed = umbrage.measure("primitives", size=(64, 36), frames=2)
    assert timed["milliseconds"]["frame"]["median"] > 0


def test_a_shaders_text_is_the_commands():
    words = ["wgsl", "--stage", "caster", "--group", "2", "--preset", "soft"]
    assert umbrage.wgsl(stage="caster", group=2, preset="soft") == command(*words)
    assert umbrage.wgsl() == command("wgsl")


def test_worlds_and_settings_are_the_commands():
    worlds, settings = umbrage.worlds(), umbrage.settings()
    assert worlds == command_json("worlds") and settings == command_json("settings")
    assert [world["name"] for world in worlds if world["is_default"]] == ["mining-terrain"]
    [splits] = [setting for setting in settings if setting["name"] == "splits"]
    assert splits["default"] == 4 and "1 to 9" in splits["values"]
    assert len({setting["name"] for setting in settings}) > 50


def test_the_version_is_the_commands():
    assert f"umbrage {umbrage.__version__}\n" == command("--version")
