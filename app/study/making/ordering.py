"""The order of lines and clips for each rater: balanced Latin squares.

In a Williams square each item occurs once a row, equally often in each position, and equally often right after each
other item. Raters take the rows in turn, so that orders are balanced after every whole square.
"""

from collections.abc import Sequence
from math import lcm

Order = tuple[int, ...]


def williams_square(count: int) -> tuple[Order, ...]:
    """The orders of `count` items: `count` rows, or twice as many if the count is odd."""
    first = [place // 2 if place % 2 == 0 else count - 1 - place // 2 for place in range(count)]
    rows = [tuple((thing + shift) % count for thing in first) for shift in range(count)]
    return tuple(rows) if count % 2 == 0 else tuple(rows + [row[::-1] for row in rows])


def rater_orders(lines: int, clips: int) -> tuple[tuple[tuple[int, Order], ...], ...]:
    """For each rater, until the orders repeat: the lines in the order in which he sees them, each with the order of its
    clips.

    A line has every order of its clips equally often over the raters, and a rater has different orders line by line.
    """
    squares = williams_square(lines), williams_square(clips)
    raters = range(lcm(len(squares[0]), len(squares[1])))
    return tuple(_orders(squares, rater) for rater in raters)


def _orders(squares: tuple[Sequence[Order], Sequence[Order]], rater: int) -> tuple[tuple[int, Order], ...]:
    of_lines, of_clips = squares
    return tuple((line, of_clips[(rater + line) % len(of_clips)]) for line in of_lines[rater % len(of_lines)])
