"""How much memory a worker may take: set where the kernel refuses it more, and what is told then."""

import resource
from pathlib import Path

from ...errors import TooLargeError


def limit_memory(limit_bytes: int) -> None:
    """Lets this process, and each that it starts, write to so much memory beyond what it has now. Linux alone tells how
    much that is; elsewhere the service's watch is the only limit."""
    status = Path("/proc/self/status")
    if status.exists():
        [data] = [line for line in status.read_text().splitlines() if line.startswith("VmData:")]
        limit_bytes += int(data.split()[1]) * 1024
        resource.setrlimit(resource.RLIMIT_DATA, (limit_bytes, limit_bytes))


def too_large(limit_bytes: int) -> TooLargeError:
    """What is told of work that needs more memory than a worker may take."""
    return TooLargeError(
        "work_too_large", f"this takes more than the {limit_bytes} bytes of memory that a request may use; send less"
    )
