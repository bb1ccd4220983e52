"""A process of the service ends when the service's end of its socket does, be it that the service has died or that
whoever waited has left: at once, whatever it does, and with all that it started.
"""

import os
import select
import socket
import threading
from typing import Never

import psutil


def end_with(service: socket.socket) -> None:
    """Has this process end with the other end of its socket."""
    threading.Thread(target=_wait, args=(service,), daemon=True).start()


def end() -> Never:
    """Ends this process and its children."""
    for child in psutil.Process().children(recursive=True):
        child.kill()
    os._exit(0)


def _wait(service: socket.socket) -> None:
    poller = select.poll()
    poller.register(service, 0)
    poller.poll()  # returns when the other end has gone
    end()
