"""The arguments of `understudy serve`."""

import argparse

from .command import Adding

LARGEST_PORT = 65535


def add_serve(add: Adding) -> None:
    parser = add("serve", "answer over HTTP")
    parser.add_argument("--host", help="address to listen on (default: UNDERSTUDY_HOST, else 127.0.0.1)")
    parser.add_argument("--port", type=_port, help="port to listen on (default: UNDERSTUDY_PORT, else 8000)")
    parser.add_argument("--reload", action="store_true", help="read rules, words and characters again when saved")


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is not a port, which is a number from 0 to {LARGEST_PORT}")
    return int(text)
