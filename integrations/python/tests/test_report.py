"""Reports: rows, pages, shares, and who measured."""

from __future__ import annotations

import sys

import pandas
import pytest
import umbrage
from conftest import command, left


def test_rows_are_those_of_the_commands_csv(experiment, tmp_path):
    rows = umbrage.report(experiment, tmp_path / "ours")
    command("report", str(experiment), "-o", str(tmp_path / "commands"))
    assert isinstance(rows, pandas.DataFrame) and len(rows) == 8
    theirs = pandas.read_csv(tmp_path / "commands" / "small.csv")
    # pandas may round the last digit of what it reads, and has its own names for what is not there.
    pandas.testing.assert_frame_equal(rows.fillna(0), theirs.fillna(0), check_dtype=False, rtol=1e-14)
    ours, commands = left(tmp_path / "ours"), left(tmp_path / "commands")
    assert ours.keys() == commands.keys()
    # They differ in who measured, which the page and the JSON name.
    assert {name for name in ours if ours[name] != commands[name]} == {"small.html", "small.json"}


def test_without_pandas_rows_are_dictionaries(experiment, tmp_path, monkeypatch):
    frame = umbrage.report(experiment, tmp_path / "out")
    monkeypatch.setitem(sys.modules, "pandas", None)
    rows = umbrage.report(experiment, tmp_path / "out")
    assert isinstance(rows, list) and len(rows) == 8
    assert [row["error.mis_shadowed"] for row in rows] == frame["error.mis_shadowed"].tolist()
    assert rows[0]["variant"] == "coarse" and rows[0]["repeat"] == 0 and rows[0]["sun.rmse"] is None


def test_shards_and_a_merge_are_one_report(experiment, tmp_path):
    umbrage.report(experiment, tmp_path / "whole")
    shards = [tmp_path / name for name in ("a", "b")]
    counts = [len(umbrage.report(experiment, folder, shard=(i, 2))) for i, folder in enumerate(shards, 1)]
    assert counts == [4, 4] and not left(shards[0])
    with pytest.raises(RuntimeError, match="4 of 8 runs are in none of the stores"):
        umbrage.report(experiment, tmp_path / "half", merge=shards[:1])
    umbrage.report(experiment, tmp_path / "merged", merge=shards)
    assert left(tmp_path / "merged") == left(tmp_path / "whole")
    with pytest.raises(ValueError, match="as 2/8 for the second of eight"):
        umbrage.report(experiment, tmp_path / "out", shard=(3, 2))


def test_results_of_the_command_are_not_taken_for_those_of_the_module(experiment, tmp_path):
    command("report", str(experiment), "-o", str(tmp_path / "theirs"))
    before = set((tmp_path / "theirs" / "runs").iterdir())
    with pytest.raises(RuntimeError, match="made by another program"):
        umbrage.report(experiment, tmp_path / "out", merge=[tmp_path / "theirs"])
    umbrage.report(experiment, tmp_path / "theirs")
    assert len(set((tmp_path / "theirs" / "runs").iterdir())) == 2 * len(before), "each has its own"
