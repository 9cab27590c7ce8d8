"""What the tests share: the command that the module must agree with, and a small experiment."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))

# Eight runs; nothing is timed, so that all is the same each time.
EXPERIMENT = """title = "A small experiment"
source = "this project"
worlds = ["primitives"]
cameras = ["main", "close"]
size = [96, 54]
repeats = 2
columns = ["error.mis_shadowed", "bytes"]

[[variants]]
name = "coarse"
set = { resolution = 128 }

[[variants]]
name = "fine"
"""


@pytest.fixture
def experiment(tmp_path: Path) -> Path:
    path = tmp_path / "small.toml"
    path.write_text(EXPERIMENT)
    return path


def command(*words: str) -> str:
    """What the command prints."""
    done = subprocess.run([TARGET / "debug" / "umbrage", *words], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def command_json(*words: str):
    return json.loads(command(*words, "--json", "-"))


def left(folder: Path) -> dict[str, bytes]:
    """What a report leaves, by its path in the folder, but for the results."""
    files = (path for path in folder.rglob("*") if path.is_file())
    apart = ("runs", "shards")
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in files
        if path.relative_to(folder).parts[0] not in apart
    }
