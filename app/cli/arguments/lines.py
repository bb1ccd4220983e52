"""The arguments of the commands that take a line or a recording: `perform`, `realize` and the analyses."""

import argparse

from ...option_table import MOTION, PERFORMANCE
from ..files import STANDARD, InputFile, OutputName
from .options import (
    AUDIO_HELP,
    MOTION_HELP,
    Adding,
    add_agitation_model,
    add_form,
    add_functions,
    add_line,
    add_manner,
    add_motion,
    add_motion_model,
    add_option,
    add_options,
    add_output,
    add_reference,
    add_text,
    add_words,
)


def add_perform(add: Adding) -> None:
    parser = add("perform", "perform one line: audio and words in, BML out")
    add_line(parser)
    _add_performance(parser)
    add_reference(parser)
    add_agitation_model(parser)
    add_motion_model(parser)


def add_say(add: Adding) -> None:
    parser = add("say", "perform a line without a recording: words in, timed as they are usually spoken, BML out")
    add_text(parser, "the words, with *marks* of emphasis, or as XML with the tags of SSML or APML")
    add_words(parser, "the word times of a speech synthesizer: .json, .TextGrid or .ctm (default: estimated)")
    _add_performance(parser)
    parser.set_defaults(audio=None, reference=None, motion_model=None, scenario=None)


def _add_performance(parser: argparse.ArgumentParser) -> None:
    """Adds the line's annotations, the options of its performance, and the outputs."""
    add_functions(parser)
    parser.add_argument(
        "--direction", metavar="FILE", type=InputFile, help="a director's notes on the line: JSON (docs/directing.md)"
    )
    help_text = "an author's changes to the performance: JSON (docs/edits.md)"
    parser.add_argument("--edits", metavar="FILE", type=InputFile, help=help_text)
    add_output(
        parser, "OUT.bml", "output file, BML or, named OUT.json, JSON (default: standard output)", default=STANDARD
    )
    add_manner(parser)
    add_options(parser, PERFORMANCE, "listener")
    add_form(parser)
    parser.add_argument(
        "--trace",
        metavar="FILE",
        type=OutputName,
        help="also write the whole performance as JSON, with the reason for every decision",
    )
    parser.add_argument(
        "--realize",
        metavar="FILE",
        type=OutputName,
        action="append",
        default=[],
        help=f"also write the motion: {MOTION_HELP}; repeatable",
    )
    add_motion(parser)


def add_script(add: Adding) -> None:
    parser = add(
        "script",
        "write a line's gestures in the style of a speaker's profile: a gesture script, JSON that realize plays",
    )
    add_line(parser)
    add_functions(parser)
    add_option(parser, PERFORMANCE["profile"], required=True)
    add_options(parser, PERFORMANCE, "character", "agitation", "affect", "seed", "choice", "lead_in_s")
    add_output(parser, "SCRIPT.json", "output file (default: standard output)", default=STANDARD)


def add_realize(add: Adding) -> None:
    parser = add("realize", "turn BML into motion")
    parser.add_argument(
        "bml",
        metavar="FILE.bml",
        type=InputFile,
        help="BML 1.0 core or SmartBody's, the gesture script of understudy script, or MPEG-4 parameters (.bap, .fap); "
        "- for standard input",
    )
    parser.add_argument("--fap", metavar="FILE.fap", type=InputFile, help="the face that goes with FILE.bap")
    parser.add_argument(
        "--audio", metavar="AUDIO", type=InputFile, help="the recording of the speech, for lips and words"
    )
    parser.add_argument(
        "-o",
        "--output",
        metavar="OUT",
        type=OutputName,
        action="append",
        required=True,
        help=f"{MOTION_HELP}; repeatable",
    )
    add_options(parser, MOTION, "character", "agitation", "seed", "stillness", "targets")
    add_motion(parser)


def add_live(add: Adding) -> None:
    parser = add("live", "gestures for live speech, without a transcript; one JSON object a line")
    heard = parser.add_mutually_exclusive_group(required=True)
    heard.add_argument("audio", metavar="FILE", type=InputFile, nargs="?", help=AUDIO_HELP)
    heard.add_argument("--microphone", action="store_true", help="use the microphone (needs the extra `microphone`)")
    parser.add_argument(
        "--rate",
        metavar="HZ",
        type=int,
        help="FILE is raw 16-bit little-endian mono at this sample rate; standard input is read as it arrives",
    )
    parser.add_argument(
        "--frames", type=int, choices=(30, 60), help="also output the body's joints, at this frame rate"
    )
    parser.add_argument(
        "--vmc", metavar="HOST:PORT", help="stream the motion to an avatar by VMC, usually at port 39539"
    )
    parser.add_argument(
        "--vmc-face",
        choices=("presets", "arkit", "none"),
        default="presets",
        help="names of the face's blendshapes in VMC",
    )
    parser.add_argument("--vmc-without-head", action="store_true", help="leave neck, head and eyes to a tracker")
    parser.add_argument(
        "--live-link-face",
        metavar="HOST:PORT",
        help="stream the face as the app Live Link Face does, usually to port 11111",
    )
    help_text = "move arms, trunk and head with a motion model: one made by understudy motion-model train, or default"
    parser.add_argument("--model", metavar="MODEL", type=InputFile, help=help_text)
    help_text = (
        "with --model, search only durations of 1, 1 + M, 1 + 2 M … frames after the N best kinds (default: all)"
    )
    parser.add_argument("--search", metavar=("M", "N"), type=int, nargs=2, help=help_text)
    add_options(parser, PERFORMANCE, "character")
    add_option(parser, PERFORMANCE["seed"], help="random seed of the movements (default 0)")
    add_output(parser, "OUT.jsonl", "output file (default: standard output)", default=STANDARD)


def add_analyses(add: Adding) -> None:
    analyze = add("analyze", "analyse a line before any movement is chosen: words, voice and functions, as JSON")
    add_line(analyze)
    add_functions(analyze)
    add_agitation_model(analyze)
    add_options(analyze, PERFORMANCE, "agitation", "affect")
    add_reference(analyze)
    analyze.add_argument(
        "--plot", metavar="FILE", type=OutputName, help="also plot the analysis, as PNG (needs the extra `plot`)"
    )
    align = add("align", "find the times of words and phones in a recording")
    add_line(align)
    align.add_argument("--format", choices=("json", "textgrid", "ctm"), default="json")
    pitch = add("pitch", "measure pitch and energy every 10 ms")
    pitch.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    pitch.add_argument("--format", choices=("csv",), default="csv")
    agitation = add("agitation", "measure the speaker's agitation, one line of JSON for each file")
    agitation.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=AUDIO_HELP)
    add_reference(agitation)
    add_agitation_model(agitation)
    train = add("agitation train", "train the classifier of agitation on your own actors' recordings")
    help_text = "a table with the columns file, speaker, agitation (low, medium, high), and perhaps emotion"
    train.add_argument("labels", metavar="LABELS.csv", type=InputFile, help=help_text)
    add_output(train, "MODEL", "output file (.npz), for --agitation-model")
    reference = add("reference", "measure how a speaker usually sounds, for --reference")
    spoken = "recordings of one speaker in various moods"
    reference.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="+", help=spoken)
    add_output(reference, "REF.json", "output file (default: standard output)", default=STANDARD)
    functions = add(
        "functions", "find the communicative functions of words alone; without --text, JSON lines in and out"
    )
    functions.add_argument("--text", help='the words; without it, lines of {"id", "text"} from standard input')
