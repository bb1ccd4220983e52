"""The arguments of `understudy serve` and `understudy studio`."""

import argparse

from ..distinct_files import InputFile
from .command import Adding
from .shared import add_agitation_model

LARGEST_PORT = 65535


def add_serve(add: Adding) -> None:
    parser = add("serve", "run the HTTP service")
    parser.add_argument("--host", help="address to listen on (default: UNDERSTUDY_HOST, else 127.0.0.1)")
    parser.add_argument("--port", type=_port, help="port to listen on (default: UNDERSTUDY_PORT, else 8000)")
    add_agitation_model(parser)
    _add_origins(parser)
    parser.add_argument("--reload", action="store_true", help="read rules, words and characters again when saved")


def add_studio(add: Adding) -> None:
    parser = add("studio", "open the studio page: perform a line, look at it, change it, export it")
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="?", help="a line to open (WAV, FLAC, OGG)")
    text = parser.add_mutually_exclusive_group()
    text.add_argument("--text", help="the words that are spoken")
    text.add_argument("--text-file", metavar="FILE", type=InputFile, help="a file that holds them")
    parser.add_argument("--scene", metavar="DIR", help="a scene for a table read: the folder that batch wrote to")
    parser.add_argument("--port", type=_port, default=0, help="port to listen on (default: one that is free)")
    parser.add_argument("--rules", metavar="DIR", help="a folder in which the page may save edited rules and words")
    add_agitation_model(parser)
    _add_origins(parser)
    parser.add_argument("--no-browser", action="store_true", help="only say where the page is")
    parser.add_argument("--reload", action="store_true", help="read rules, words and characters again when saved")


def _add_origins(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--allow-origin",
        metavar="ORIGIN",
        action="append",
        help="pages of this origin, such as http://localhost:5173, may call the service; may be repeated",
    )


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is not a port, which is a number from 0 to {LARGEST_PORT}")
    return int(text)
