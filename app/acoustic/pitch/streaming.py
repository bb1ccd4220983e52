"""Tracks f0 as `understudy.acoustic.pitch.tracking` does, for a signal that is still being received.

Statistics of the whole recording are replaced by those of the past: the speaker's range is that of the reliable frames
so far, loud and quiet are levels of the last `LEVEL_FRAMES`. The path through the candidates is decided `PATH_FRAMES`
behind the last frame, undecided voicing `VOICING_FRAMES` later. Including its window and blocks of `RESIDUAL_FRAMES`, a
frame is decided at most `LATEST_S` after it was received.

`python -m benchmarks.live.pitch` compares it with the tracker for recordings.
"""

from collections import deque
from itertools import accumulate

import numpy as np

from ...model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, FloatArray, SingleArray
from ..signal.frames import SHIFT_SAMPLES, frame_count
from .harmonics import CANDIDATES_HZ, MARGIN, RESIDUAL_FRAMES, best_path, summed_harmonics
from .tracking import (
    RANGE_THRESHOLD,
    TUNED,
    Candidates,
    Tuning,
    candidates_of,
    frame_weights,
    merits_of,
    speaker_range,
)
from .voicing import (
    LOUD_PERCENTILE,
    QUIET_PERCENTILE,
    WIDEST_ABOVE_QUIET_DB,
    WIDEST_BELOW_LOUD_DB,
    Levels,
    band_level_db,
    band_power,
    measures,
    periods_nearby,
)

PATH_FRAMES = 2
VOICING_FRAMES = 2
NEEDED_SAMPLES = 1200
"""The samples needed after a frame's centre: half of its window of 100 ms, and of the residual's windows."""

LATEST_S = NEEDED_SAMPLES / SAMPLE_RATE_HZ + (RESIDUAL_FRAMES + PATH_FRAMES + VOICING_FRAMES) * FRAME_SHIFT_S
LEVEL_FRAMES = 1000
RELIABLE_FRAMES = 3000
"""How many reliable f0 values are remembered."""

FEWEST_RELIABLE = 10
LEAST_RANGE_DB = 20.0
"""The loud level is at least this far above the quiet one, also before anything loud is heard."""


class StreamingPitch:
    """Takes samples at `SAMPLE_RATE_HZ` and returns the f0 of each frame, 0 where unvoiced, as it is decided."""

    def __init__(self, tuning: Tuning = TUNED) -> None:
        self._tuning = tuning
        self._samples: FloatArray = np.empty(0)
        self._begin = self._heard = self._next = 0
        self._levels_db: deque[float] = deque(maxlen=LEVEL_FRAMES)
        self._reliable: deque[float] = deque(maxlen=RELIABLE_FRAMES)
        self._path = _PendingPath(tuning)
        self._voicing = _PendingVoicing(tuning)

    def hear(self, samples: FloatArray) -> FloatArray:
        """The f0 in Hz of the frames that are decided once these samples are known."""
        self._samples = np.concatenate([self._samples, samples])
        self._heard += len(samples)
        decided = []
        while self._heard >= (self._next + RESIDUAL_FRAMES - 1) * SHIFT_SAMPLES + NEEDED_SAMPLES:
            decided.append(self._decided(RESIDUAL_FRAMES, PATH_FRAMES))
            self._forget()
        return np.concatenate([*decided, np.empty(0)])

    def finish(self) -> FloatArray:
        """The f0 of the remaining frames after the end of the signal; in total as many as a recording would have."""
        decided = []
        while (left := frame_count(self._heard) - self._next) > 0:
            decided.append(self._decided(min(left, RESIDUAL_FRAMES), PATH_FRAMES if left > RESIDUAL_FRAMES else 0))
        return np.concatenate([*decided, self._voicing.finish()])

    def _decided(self, count: int, behind: int) -> FloatArray:
        """Measures the next frames, and returns the f0 of those decided by them."""
        first = self._next - self._begin // SHIFT_SAMPLES
        self._next += count
        frames = range(first, first + count)
        srh = np.concatenate(
            [each for _, each in summed_harmonics(self._samples, self._tuning.unit_energy_band_hz, frames)], axis=1
        )
        power = self._power(frames)
        found = candidates_of(srh, self._range(srh), self._tuning)
        self._path.add(found, power, self._levels(power))
        return self._voicing.add(*self._path.decided(behind))

    def _power(self, frames: range) -> SingleArray:
        """The power of frames, without transforming those before them."""
        before = min(frames.start, 2)
        begin = (frames.start - before) * SHIFT_SAMPLES
        return band_power(self._samples[begin : begin + (before + len(frames) + 2) * SHIFT_SAMPLES])[
            before : before + len(frames)
        ]

    def _range(self, srh: SingleArray) -> slice:
        """The speaker's range, from all frames so far."""
        merits = merits_of(srh, self._tuning.submultiple_share)
        best = merits.argmax(axis=0)
        self._reliable.extend(CANDIDATES_HZ[best[merits.max(axis=0) > RANGE_THRESHOLD]].tolist())
        known = self._reliable if len(self._reliable) >= FEWEST_RELIABLE else ()
        return speaker_range(np.array(known), self._tuning)

    def _levels(self, power: SingleArray) -> Levels:
        level_db = band_level_db(power)
        self._levels_db.extend(level_db.tolist())
        loud_db, quiet_db = np.percentile(np.array(self._levels_db), [LOUD_PERCENTILE, QUIET_PERCENTILE])
        loud_db = max(loud_db, quiet_db + LEAST_RANGE_DB)
        return Levels(
            below_loud_db=np.clip(level_db - loud_db, -WIDEST_BELOW_LOUD_DB, 0),
            above_quiet_db=np.clip(level_db - quiet_db, 0, WIDEST_ABOVE_QUIET_DB),
        )

    def _forget(self) -> None:
        """Drops samples that no frame needs any more."""
        begin = max(0, self._next * SHIFT_SAMPLES - MARGIN)
        self._samples = self._samples[begin - self._begin :]
        self._begin = begin


class _PendingPath:
    """The candidates of frames without a decision, and the last one chosen."""

    def __init__(self, tuning: Tuning) -> None:
        self._tuning = tuning
        self._gains, self._octaves, self._f0_hz, self._srh = (np.empty((0, 10)) for _ in range(4))
        self._power: SingleArray = np.empty((0, 0), dtype=np.float32)
        self._levels = np.empty((0, 2))
        self._fixed = False

    def add(self, found: Candidates, power: SingleArray, levels: Levels) -> None:
        gains = found.merits * frame_weights(levels, self._tuning.faintest_weight)[:, None]
        self._gains = np.concatenate([self._gains, gains])
        self._octaves = np.concatenate([self._octaves, found.octaves])
        self._f0_hz = np.concatenate([self._f0_hz, found.f0_hz])
        self._srh = np.concatenate([self._srh, found.srh])
        self._power = np.concatenate([self._power, power]) if self._power.size else power
        columns = np.column_stack([levels.below_loud_db, levels.above_quiet_db])
        self._levels = np.concatenate([self._levels, columns])

    def decided(self, behind: int) -> tuple[FloatArray, FloatArray]:
        """The f0 and the evidence of voicing of all frames but the last `behind`; the path continues from there."""
        first, last = int(self._fixed), len(self._gains) - behind
        if last <= first:
            return np.empty(0), np.empty((0, 4))
        path = best_path(self._gains, self._octaves, self._tuning.octave_cost)[:last]
        rows = np.arange(last)
        f0_hz, srh = self._f0_hz[rows, path][first:], self._srh[rows, path][first:]
        refined_hz, correlation = periods_nearby(self._power[first:last], f0_hz)
        evidence = measures(srh, correlation, Levels(*self._levels[first:last].T))
        self._go_on(last - 1, int(path[-1]))
        return refined_hz if self._tuning.refines else f0_hz, evidence

    def _go_on(self, row: int, column: int) -> None:
        """Keeps what is not decided, and the last decided frame with only its chosen candidate."""
        self._gains, self._octaves = self._gains[row:].copy(), self._octaves[row:]
        self._f0_hz, self._srh = self._f0_hz[row:], self._srh[row:]
        self._power, self._levels = self._power[row:], self._levels[row:]
        self._gains[0] = -np.inf
        self._gains[0, column] = 0.0
        self._fixed = True


class _PendingVoicing:
    """The frames whose voicing is not decided yet (`voicing.voiced_frames`)."""

    def __init__(self, tuning: Tuning) -> None:
        self._voicing = tuning.voicing
        self._f0_hz = np.empty(0)
        self._advantages: FloatArray = np.empty(0)
        self._before = 0.0

    def add(self, f0_hz: FloatArray, evidence: FloatArray) -> FloatArray:
        """The f0 of the frames that are decided once these are known, 0 where unvoiced."""
        cost = self._voicing.change_cost
        excess = evidence @ self._voicing.weights - self._voicing.threshold
        more = list(
            accumulate(excess.tolist(), lambda before, here: min(max(before, -cost), cost) + here, initial=self._before)
        )
        self._before = more[-1]
        self._f0_hz = np.concatenate([self._f0_hz, f0_hz])
        self._advantages = np.concatenate([self._advantages, more[1:]])
        decided = np.flatnonzero(np.abs(self._advantages) >= cost)
        count = max(int(decided[-1]) + 1 if len(decided) else 0, len(self._f0_hz) - VOICING_FRAMES)
        return self._leave(count)

    def finish(self) -> FloatArray:
        return self._leave(len(self._f0_hz))

    def _leave(self, count: int) -> FloatArray:
        """Decides this many frames: each as the next certain one, the last ones as they are."""
        if not count:
            return np.empty(0)
        certain = np.abs(self._advantages[:count]) >= self._voicing.change_cost
        certain[-1] = True
        deciding = np.flatnonzero(certain)[np.cumsum(certain) - certain]
        left = np.where(self._advantages[deciding] > 0, self._f0_hz[:count], 0.0)
        self._f0_hz, self._advantages = self._f0_hz[count:], self._advantages[count:]
        return left
