"""A smoothed n-gram model of sequences of numbers below 1024: interpolated Kneser-Ney, in back-off form.

An n-gram is packed into one 64-bit integer, ten bits a symbol, the latest lowest, so that the context of an n-gram is
`key >> 10` and its own shorter form `key & mask`. Source: Chen & Goodman 1999, §2.7, with one discount an order.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

BITS = 10
Keys = NDArray[np.int64]
Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Order:
    """All n-grams of one length, sorted by key, with natural log probability and back-off weight."""

    keys: Keys
    log_probability: Floats
    log_backoff: Floats


def estimate(sequences: Sequence[Sequence[int]], *, start: int, min_counts: Sequence[int]) -> tuple[Order, ...]:
    """The model of `sequences`, each beginning with the symbol `start`, which is never predicted.

    `min_counts[k]` is how often an n-gram of k + 1 symbols must occur to be kept; it must not fall with k.
    """
    raw = [_windows(sequences, length) for length in range(1, len(min_counts) + 1)]
    orders: list[Order] = []
    lower = np.array([0.0])
    for length, (keys, counts) in enumerate(raw, start=1):
        smoothed = counts if length == len(raw) else _continuations(keys, counts, raw[length][0], length, start)
        probability = _interpolated(keys, smoothed, raw[length - 2][0] if length > 1 else None, lower)
        if length == 1:
            probability[keys == start] = 1e-30
        kept = (counts >= min_counts[length - 1]) | (length == 1)
        orders.append(Order(keys[kept], np.log(probability[kept]), np.zeros(int(kept.sum()))))
        lower = probability
    return tuple(_with_backoff(orders))


def _windows(sequences: Sequence[Sequence[int]], length: int) -> tuple[Keys, Floats]:
    """Every n-gram of `length` in the sequences, sorted, and how often it occurs."""
    packed = []
    for sequence in sequences:
        symbols = np.asarray(sequence, dtype=np.int64)
        if len(symbols) < length:
            continue
        key = np.zeros(len(symbols) - length + 1, dtype=np.int64)
        for offset in range(length):
            key = (key << BITS) | symbols[offset : offset + len(key)]
        packed.append(key)
    keys, counts = np.unique(np.concatenate(packed), return_counts=True)
    return keys, counts.astype(np.float64)


def _continuations(keys: Keys, counts: Floats, longer: Keys, length: int, start: int) -> Floats:
    """After how many different symbols each n-gram occurs; its plain count if it opens the sequence."""
    tails, numbers = np.unique(longer & _mask(length), return_counts=True)
    result = counts.copy()
    opens = (keys >> (BITS * (length - 1))) == start
    result[~opens] = numbers[np.searchsorted(tails, keys[~opens])]
    return result


def _interpolated(keys: Keys, counts: Floats, lower_keys: Keys | None, lower: Floats) -> Floats:
    """Probability of the last symbol of each n-gram given the others, interpolated with the shorter n-gram's."""
    once, twice = float((counts == 1).sum()), float((counts == 2).sum())
    discount = once / (once + 2 * twice) if once else 0.5
    contexts, index = np.unique(keys >> BITS, return_inverse=True)
    totals = np.bincount(index, weights=counts, minlength=len(contexts))
    types = np.bincount(index, minlength=len(contexts))
    shorter = (
        np.full(len(keys), 1 / len(keys))
        if lower_keys is None
        else lower[np.searchsorted(lower_keys, keys & _mask(_length(lower_keys)))]
    )
    result: Floats = (np.maximum(counts - discount, 0) + discount * types[index] * shorter) / totals[index]
    return result


def _with_backoff(orders: Sequence[Order]) -> list[Order]:
    """The orders with the weights that make every context's probabilities sum to one again."""
    result = []
    for length, order in enumerate(orders, start=1):
        backoff = np.zeros(len(order.keys))
        if length < len(orders):
            longer = orders[length]
            parents = np.searchsorted(order.keys, longer.keys >> BITS)
            tails = np.searchsorted(order.keys, longer.keys & _mask(length))
            used = np.bincount(parents, weights=np.exp(longer.log_probability), minlength=len(order.keys))
            covered = np.bincount(parents, weights=np.exp(order.log_probability[tails]), minlength=len(order.keys))
            backoff = np.log(np.maximum(1 - used, 1e-6) / np.maximum(1 - covered, 1e-6))
        result.append(Order(order.keys, order.log_probability, backoff))
    return result


def _mask(length: int) -> int:
    return (1 << (BITS * length)) - 1


def _length(keys: Keys) -> int:
    """How many symbols the n-grams of `keys` have; no symbol is 0."""
    return -(-int(keys[-1]).bit_length() // BITS)
