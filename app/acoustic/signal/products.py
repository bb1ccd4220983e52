"""Products with a matrix that stay on one processor.

OpenBLAS shares what takes more than 2^18 multiplications among all processors. Frames of speech are too few for that:
on two processors the contours of a line took twice the processor time, and no less time by the clock.
"""

import numpy as np

from ...model import FloatArray

MULTIPLICATIONS = 2**18


def product(rows: FloatArray, matrix: FloatArray) -> FloatArray:
    """`rows @ matrix` (rows × columns), some rows at a time."""
    at_once = max(MULTIPLICATIONS // matrix.size, 1)
    found = np.empty((len(rows), matrix.shape[1]), dtype=np.result_type(rows, matrix))
    for first in range(0, len(rows), at_once):
        np.matmul(rows[first : first + at_once], matrix, out=found[first : first + at_once])
    return found
