"""Numbers are written as `%.Nf` writes them, whatever their size and sign."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.exporting.fixed_decimals import RowFormat, written_rows


def one_by_one(table: FloatArray, row: RowFormat) -> bytes:
    rounded = np.round(table, row.decimals) + 0.0
    rows = (row.between.join(f"{number:.{row.decimals}f}" for number in each) for each in rounded.tolist())
    return "".join(f"{row.before}{each}{row.after}" for each in rows).encode()


@pytest.mark.parametrize("size", [1e-6, 1.0, 250.0, 1e7])
@pytest.mark.parametrize("row", [RowFormat(5, "[", ",", "],"), RowFormat(4), RowFormat(1, between=" ", after="\n")])
def test_numbers_are_written_as_one_by_one(size: float, row: RowFormat) -> None:
    tables = size * np.random.default_rng(3).normal(size=(3, 50, 4))
    assert written_rows(tables, row) == [one_by_one(table, row) for table in tables]


def test_zero_has_no_sign_and_a_whole_part_no_leading_zeros() -> None:
    table = np.array([[[0.0, -0.0, -0.00004, -0.00006], [9.99996, -10.0, 0.5, 123.0]]])
    [written] = written_rows(table, RowFormat(4, after="\n"))
    assert written == b"0.0000,0.0000,0.0000,-0.0001\n10.0000,-10.0000,0.5000,123.0000\n"
