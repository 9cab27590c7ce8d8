"""The rows of a report, from its CSV."""

from __future__ import annotations

import csv
import io
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas


def rows_of(text: str) -> pandas.DataFrame | list[dict[str, Any]]:
    """A data frame where pandas is installed, and otherwise a list with a dictionary for each row."""
    rows = [{key: _value(field) for key, field in row.items()} for row in csv.DictReader(io.StringIO(text))]
    try:
        import pandas
    except ImportError:
        return rows
    return pandas.DataFrame(rows)


def _value(field: str) -> Any:
    """A number or a truth value where it is one; ``None`` where there is no such figure."""
    if field in ("", "true", "false"):
        return {"": None, "true": True, "false": False}[field]
    for number in (int, float):
        try:
            return number(field)
        except ValueError:
            pass
    return field
