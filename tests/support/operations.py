"""How much work Python does, counted, not timed: the operations of its interpreter, or the calls."""

import sys
from collections.abc import Callable
from types import FrameType


def operations_of(work: Callable[[], object]) -> int:
    """The number of byte-code instructions that `work` runs; what C code does inside one counts as one."""
    count = 0

    def trace(frame: FrameType, event: str, _argument: object) -> object:
        nonlocal count
        frame.f_trace_opcodes, frame.f_trace_lines = True, False
        count += event == "opcode"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)  # type: ignore[arg-type]
    try:
        work()
    finally:
        sys.settrace(before)
    return count


def calls_of(work: Callable[[], object]) -> int:
    """The number of functions that `work` calls, ours and those in C: coarser than operations, and counted sooner."""
    count = 0

    def profile(_frame: FrameType, event: str, _argument: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(profile)
    try:
        work()
    finally:
        sys.setprofile(before)
    return count
