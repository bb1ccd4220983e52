"""Matrix products that stay on one processor core.

OpenBLAS distributes more than 2^18 multiplications over all cores. Speech frames are too few for that to pay: on two
cores the contours of a line took twice the processor time and no less elapsed time.
"""

import numpy as np

from ...model import FloatArray

MULTIPLICATIONS = 2**18


def product(rows: FloatArray, matrix: FloatArray) -> FloatArray:
    """`rows @ matrix` (rows × columns), computed in slices of rows."""
    at_once = max(MULTIPLICATIONS // matrix.size, 1)
    found = np.empty((len(rows), matrix.shape[1]), dtype=np.result_type(rows, matrix))
    for first in range(0, len(rows), at_once):
        np.matmul(rows[first : first + at_once], matrix, out=found[first : first + at_once])
    return found
