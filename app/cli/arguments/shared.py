"""Arguments that several commands take: the line, what is known of it, and the output."""

import argparse

from ..distinct_files import InputFile, OutputFile

MOTION_HELP = (
    ".bvh, .glb, .vrma, .json, .csv (ARKit), .visemes.txt, .usda, .usdc, .usdz, .fbx (by Blender), .otio, "
    ".TextGrid, .eaf, .events.csv, .bap, .fap, "
    ".png (contact sheet) or .speed.png (wrist speeds)"
)
AUDIO_HELP = "WAV, FLAC or OGG file; - for standard input"


def add_line(parser: argparse.ArgumentParser) -> None:
    """The recording, its words and their times."""
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    add_text(parser, "the words that are spoken")
    add_words(parser, "the words' times, made elsewhere: .json, .TextGrid or .ctm; nothing is aligned")
    parser.set_defaults(functions=None, direction=None, edits=None)


def add_text(parser: argparse.ArgumentParser, told: str) -> None:
    """The words, on the command line or in a file."""
    text = parser.add_mutually_exclusive_group(required=True)
    text.add_argument("--text", help=told)
    text.add_argument(
        "--text-file", metavar="FILE", type=InputFile, help="a file that holds them; - for standard input"
    )


def add_words(parser: argparse.ArgumentParser, told: str) -> None:
    parser.add_argument("--words", metavar="FILE", type=InputFile, help=told)


def add_agitation_model(parser: argparse.ArgumentParser) -> None:
    told = "judge agitation by a model of your own, from understudy agitation train"
    parser.add_argument("--agitation-model", metavar="MODEL", type=InputFile, help=told)


def add_motion_model(parser: argparse.ArgumentParser) -> None:
    told = "arms, trunk and head by a motion model, from understudy motion-model train, in what --realize writes"
    parser.add_argument("--motion-model", metavar="MODEL", type=InputFile, help=told)
    told = "what drives it: voice and affect (S1, S2), voice (S3, S4), affect (S5, S6), or RTS (default S1)"
    parser.add_argument("--scenario", metavar="S1…S6", default="S1", help=told)


def add_functions(parser: argparse.ArgumentParser) -> None:
    told = "communicative functions that you know already: a JSON list"
    parser.add_argument("--functions", metavar="FILE", type=InputFile, help=told)


def add_output(parser: argparse.ArgumentParser, metavar: str, told: str, *, default: str | None = None) -> None:
    """Adds the option for the output file, which is required if there is no default."""
    needed = default is None
    parser.add_argument("-o", "--output", metavar=metavar, type=OutputFile, required=needed, default=default, help=told)
