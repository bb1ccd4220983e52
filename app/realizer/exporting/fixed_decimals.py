"""Numbers with a fixed number of decimals as text, many at a time: digit by digit through NumPy, which is several times
as fast as formatting them one after the other.

Conventions: a row of numbers is written as `before`, the numbers with `between` between them, and `after`, in ASCII.
Numbers are rounded half to even, as by `numpy.round`, and zero has no sign.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray

_ZERO, _MINUS, _POINT = ord("0"), ord("-"), ord(".")
_LARGEST = 2**31 - 1
"""Larger numbers of units of the last decimal take 64 bits, in which NumPy divides at half the speed."""


@dataclass(frozen=True, slots=True)
class RowFormat:
    """What a row of numbers is written between and with, and how many decimals a number has, at least one."""

    decimals: int
    before: str = ""
    between: str = ","
    after: str = ","


def written_rows(values: FloatArray, row: RowFormat) -> list[bytes]:
    """The rows (T, N) of each of the tables (K, T, N)."""
    units = _in_units(values, row.decimals)
    whole = len(str(int(units.max(initial=0)) // 10**row.decimals))
    opens = max(len(row.before), len(row.between))
    cells = np.empty((*values.shape, opens + 1 + whole + 1 + row.decimals + len(row.after)), dtype=np.uint8)
    written = np.ones(cells.shape, dtype=bool)
    _frame(cells, written, row)
    cells[..., opens] = _MINUS
    written[..., opens] = (values < 0) & (units > 0)
    _set_digits(cells[..., opens + 1 :], written[..., opens + 1 :], units, whole, row.decimals)
    return [cell[there].tobytes() for cell, there in zip(cells, written, strict=True)]


def _in_units(values: FloatArray, decimals: int) -> NDArray[np.signedinteger]:
    """The sizes of the numbers in units of the last decimal."""
    units = np.rint(np.abs(values) * 10.0**decimals)
    return units.astype(np.int32 if units.max(initial=0.0) <= _LARGEST else np.int64)


def _frame(cells: NDArray[np.uint8], written: NDArray[np.bool_], row: RowFormat) -> None:
    """Write what stands before, between and after the numbers."""
    opens, ends = max(len(row.before), len(row.between)), len(row.after)
    for column, text in ((slice(0, 1), row.before), (slice(1, None), row.between)):
        cells[:, :, column, : len(text)] = np.frombuffer(text.encode("ascii"), np.uint8)
        written[:, :, column, len(text) : opens] = False
    if ends:
        cells[:, :, -1, -ends:] = np.frombuffer(row.after.encode("ascii"), np.uint8)
        written[:, :, :-1, -ends:] = False


def _set_digits(
    cells: NDArray[np.uint8],
    written: NDArray[np.bool_],
    units: NDArray[np.signedinteger],
    whole: int,
    decimals: int,
) -> None:
    """Write the digits, from the last to the first, and the point; no zero before the first digit of the whole part."""
    cells[..., whole] = _POINT
    for place in reversed(range(whole + decimals)):
        column = place if place < whole else place + 1
        if place < whole - 1:
            written[..., column] = units > 0
        left = units // 10
        cells[..., column] = units - 10 * left + _ZERO
        units = left
