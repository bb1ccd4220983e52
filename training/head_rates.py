"""Fits when listeners nod (`lexicon/acting/head_rates.yaml`) to the AMI meetings that are not held out.

    python -m training.head_rates [--ami FOLDER] [--target FILE]

The quarter of listeners who nod most are the measure (`benchmarks.bml.ami_heads` tells why, and how what it counts is
counted; it prints the figures of the meetings held out). `mirrored` is by how much a talker's nod is answered more
often than the same listeners nod at any time as long.
"""

import argparse
import statistics
from pathlib import Path

from benchmarks.bml.ami_heads import AMI, ECHO_S, Figures, attentive, listeners_of, pooled, read_meetings, split

TARGET = Path(__file__).resolve().parents[1] / "lexicon" / "acting" / "head_rates.yaml"

HEADER = """\
# When a listener nods, as people do (AMI meetings, CC BY 4.0; fitted by training/head_rates.py, the figures are in
# docs/measurements/bodies.md): the chance of a nod at a speaker's pause, of one at punctuation without a pause, and
# of a head movement given back as in a mirror; the delay of a nod after the end of the phrase, its mean and spread,
# in seconds.
"""


def main() -> None:
    """Writes the rates of the meetings to fit on."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--ami", type=Path, default=AMI)
    arguments.add_argument("--target", type=Path, default=TARGET)
    options = arguments.parse_args()
    fitted, _held_out = split(read_meetings(options.ami))
    rates = rates_of(pooled(Figures(), attentive(listeners_of(fitted))))
    lines = "".join(f"{name}: {value:.2f}\n" for name, value in rates.items())
    options.target.write_text(HEADER + lines, encoding="utf-8")


def rates_of(figures: Figures) -> dict[str, float]:
    """The rates of listeners' figures, by their names in the file."""
    delays = [delay for after in figures.after.values() for delay in after if delay is not None and delay > 0]
    nodded = {kind: sum(delay is not None for delay in after) / len(after) for kind, after in figures.after.items()}
    at_any_time = figures.listening["nod"] / figures.listening_s * ECHO_S
    return {
        "nods_after_pause": nodded["pause"],
        "nods_after_phrase": nodded["phrase"],
        "mirrored": max(0.0, statistics.fmean(figures.echoed) - at_any_time),
        "delay_s": statistics.fmean(delays),
        "delay_spread_s": statistics.stdev(delays),
    }


if __name__ == "__main__":
    main()
