"""Fast Fourier and cosine transforms along the last axis, by SciPy's pocketfft (`scipy.fft` has the same functions).

`import scipy.fft` takes as long as all of the analysis of a short line: it brings `scipy.special`, NumPy's test
framework and its Fortran interface with it, none of which a transform needs. So the extension module that `scipy.fft`
calls is loaded by itself, from its place in the installed SciPy (hence the upper bound on SciPy's version in
pyproject.toml). NumPy has the same algorithm, but transforms single precision five times more slowly.
"""

from importlib.machinery import PathFinder
from importlib.util import find_spec, module_from_spec
from pathlib import Path
from types import ModuleType
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

_FORWARD, _BACKWARD = True, False
_UNSCALED, _BY_LENGTH = 0, 2
_THREADS = 1


def _pocketfft() -> ModuleType:
    scipy = find_spec("scipy")
    if scipy is None or scipy.origin is None:
        raise ImportError("SciPy is not installed", name="scipy")
    spec = PathFinder.find_spec("pypocketfft", [str(Path(scipy.origin).parent / "fft" / "_pocketfft")])
    if spec is None or spec.loader is None:
        raise ImportError("this version of SciPy has no pypocketfft", name="scipy")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


_TRANSFORMS = cast(Any, _pocketfft())


def rfft(real: NDArray[np.floating], length: int | None = None) -> NDArray[Any]:
    """The spectra of real rows (`scipy.fft.rfft`), cut or padded with zeros to `length`; complex in their precision."""
    return cast(
        NDArray[Any],
        _TRANSFORMS.r2c(_of_length(real, length or real.shape[-1]), (-1,), _FORWARD, _UNSCALED, None, _THREADS),
    )


def irfft(spectra: NDArray[np.complexfloating], length: int) -> NDArray[Any]:
    """The real rows of that length with these spectra (`scipy.fft.irfft`)."""
    bins = _of_length(spectra, length // 2 + 1)
    return cast(NDArray[Any], _TRANSFORMS.c2r(bins, (-1,), length, _BACKWARD, _BY_LENGTH, None, _THREADS))


def dct1(real: NDArray[np.floating]) -> NDArray[Any]:
    """The cosine transform of type I of real rows (`scipy.fft.dct`)."""
    return cast(NDArray[Any], _TRANSFORMS.dct(real, 1, (-1,), _UNSCALED, None, _THREADS))


def _of_length(rows: NDArray[Any], length: int) -> NDArray[Any]:
    if rows.shape[-1] >= length:
        return rows[..., :length]
    padded = np.zeros((*rows.shape[:-1], length), rows.dtype)
    padded[..., : rows.shape[-1]] = rows
    return padded
