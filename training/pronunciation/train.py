"""Trains the graphone model on pocketsphinx's dictionary and measures it on words it has not seen.

    python -m training.pronunciation.train            (about two minutes, one core; ends with the figures)

A word belongs to the test set when the CRC-32 of its letters is divisible by 20, to the development set when the
remainder is 1; all its pronunciations go with it, and neither set is trained on. Words of letters a to z only.
"""

import argparse
import random
import zlib
from collections import defaultdict
from pathlib import Path

import numpy as np
from pocketsphinx import get_model_path

from training.pronunciation.ngrams import Order, estimate
from training.pronunciation.spelling import Entry, learn_graphones, segment
from understudy.acoustic.pronunciation.graphones import END, GRAPHONE_BITS, START, GraphoneModel

TARGET = Path(__file__).resolve().parents[2] / "models" / "pronunciation" / "graphones.npz"
SPLITS = 20
ENTRIES_FOR_GRAPHONES = 20_000
MIN_GRAPHONE_COUNT = 3.0
MIN_COUNTS = (1, 1, 1, 1, 2, 2)
"""Keeping every n-gram makes the model 2.8 MB instead of 1.5 for 0.7 % fewer wrong words (development set)."""
SEED = 0


def main() -> None:
    """Trains, writes and measures."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--measure", choices=("test", "development"), default="test")
    arguments.add_argument("--only-measure", action="store_true", help="measure the model that is there")
    options = arguments.parse_args()
    dictionary = read_dictionary()
    if not options.only_measure:
        entries = [(word, phones) for word, known in dictionary.items() if split(word) > 1 for phones in known]
        write(*train(entries))
    part = 0 if options.measure == "test" else 1
    measure({word: known for word, known in dictionary.items() if split(word) == part})


def read_dictionary() -> dict[str, list[tuple[str, ...]]]:
    """Every word of letters only, with its pronunciations."""
    dictionary: dict[str, list[tuple[str, ...]]] = defaultdict(list)
    path = Path(get_model_path()) / "en-us" / "cmudict-en-us.dict"
    for line in path.read_text(encoding="utf-8").splitlines():
        name, *phones = line.split()
        word = name.partition("(")[0]
        if word.isascii() and word.isalpha():
            dictionary[word].append(tuple(phones))
    return dictionary


def split(word: str) -> int:
    """Which twentieth of the words `word` belongs to."""
    return zlib.crc32(word.encode()) % SPLITS


def train(entries: list[Entry]) -> tuple[list[str], tuple[Order, ...]]:
    """The graphones by number, and the n-grams over them."""
    sample = random.Random(SEED).sample(entries, ENTRIES_FOR_GRAPHONES)
    probabilities = learn_graphones(sample, min_count=MIN_GRAPHONE_COUNT)
    graphones = ["", "<start>", "<end>", *sorted(probabilities)]
    numbers = {graphone: number for number, graphone in enumerate(graphones)}
    segmented = [segment(entry, probabilities) for entry in entries]
    sequences = [[START, *(numbers[graphone] for graphone in cut), END] for cut in segmented if cut is not None]
    print(f"{len(graphones)} graphones spell {len(sequences)} of {len(entries)} entries")
    return graphones, estimate(sequences, start=START, min_counts=MIN_COUNTS)


def write(graphones: list[str], orders: tuple[Order, ...]) -> None:
    """Writes the model as `understudy.acoustic.pronunciation.graphones` reads it."""
    arrays: dict[str, np.ndarray] = {"graphones": np.array(graphones), "order": np.array(len(orders))}
    contexts = np.array([0])
    for length, order in enumerate(orders, start=1):
        rows = np.searchsorted(contexts, order.keys >> GRAPHONE_BITS)
        keys = (rows << GRAPHONE_BITS) | (order.keys & ((1 << GRAPHONE_BITS) - 1))
        arrays[f"keys_{length}"] = np.diff(keys, prepend=0).astype(np.uint32)
        arrays[f"log_probability_{length}"] = order.log_probability.astype(np.float16)
        backoff = order.log_backoff if length < len(orders) else np.zeros(0)
        arrays[f"log_backoff_{length}"] = backoff.astype(np.float16)
        contexts = order.keys
    TARGET.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(TARGET, allow_pickle=False, **arrays)
    print(f"{TARGET}: {TARGET.stat().st_size / 1e6:.2f} MB, n-grams {[len(order.keys) for order in orders]}")


def measure(unseen: dict[str, list[tuple[str, ...]]]) -> None:
    """Prints word and phone errors against the nearest pronunciation in the dictionary."""
    model = GraphoneModel.load(TARGET)
    wrong = edits = phones = 0
    for word, known in unseen.items():
        guess = model.pronounce(word)
        distance, length = min((edit_distance(guess, phones), len(phones)) for phones in known)
        wrong += distance > 0
        edits += distance
        phones += length
    print(f"{len(unseen)} unseen words: word error {wrong / len(unseen):.1%}, phone error {edits / phones:.1%}")


def edit_distance(one: tuple[str, ...], other: tuple[str, ...]) -> int:
    """Fewest insertions, deletions and substitutions that turn `one` into `other`."""
    row = list(range(len(other) + 1))
    for index, item in enumerate(one, start=1):
        diagonal, row[0] = row[0], index
        for column, other_item in enumerate(other, start=1):
            cost = diagonal + (item != other_item)
            diagonal, row[column] = row[column], min(cost, row[column] + 1, row[column - 1] + 1)
    return row[-1]


if __name__ == "__main__":
    main()
