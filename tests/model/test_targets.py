"""What a target may be called and where it may be, and how a mistake is told."""

import pytest

from understudy.errors import InputError
from understudy.model import Target
from understudy.model.targets import FARTHEST_M, MOST_TARGETS, check_targets, read_target, read_targets, targets_of


@pytest.mark.parametrize("text", ["door=1.2,1.4,2", "door= 1.2, +1.4 ,2.0 ", " door =12e-1,1.4,2."])
def test_a_target_is_a_name_and_three_numbers(text: str) -> None:
    assert read_target(text) == Target("door", (1.2, 1.4, 2.0))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("door", "write NAME=X,Y,Z in metres"),
        ("door=", "write NAME=X,Y,Z in metres"),
        ("door=1,2", "write NAME=X,Y,Z in metres"),
        ("door=1,2,3,4", "write NAME=X,Y,Z in metres"),
        ("door=1;2;3", "write NAME=X,Y,Z in metres"),
        ("door=1,2,1_0", "write NAME=X,Y,Z in metres"),
        ("door=1,2,٣", "write NAME=X,Y,Z in metres"),
        ("door=1,nan,2", "y is nan"),
        ("door=inf,1,2", "x is inf"),
        ("door=0,0,1e999", "z is inf"),
        ("door=0,0,-1001", "z is -1001; give metres, 1000 at most"),
        ("=1,2,3", "a name has letters"),
        ("the door=1,2,3", "a name has letters"),
        (f"{'a' * 65}=1,2,3", "a name has letters"),
    ],
)
def test_a_mistake_is_told_with_what_would_be_right(text: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_targets([text])
    assert (caught.value.code, caught.value.field) == ("target_wrong", "targets")
    assert said in caught.value.message


def test_names_are_unique_and_there_are_so_many_at_most() -> None:
    with pytest.raises(InputError, match="'door' comes twice"):
        read_targets(["door=1,1,1", "window=1,1,2", "door=1,1,3"])
    many = [Target(f"t{number}", (0.0, 0.0, FARTHEST_M)) for number in range(MOST_TARGETS + 1)]
    assert check_targets(many[:-1]) == tuple(many[:-1])
    with pytest.raises(InputError, match="65 targets; 64 at most"):
        check_targets(many)


def test_positions_by_name_have_three_coordinates() -> None:
    assert targets_of({"door": [1, 2, 3]}) == (Target("door", (1.0, 2.0, 3.0)),)
    with pytest.raises(InputError, match="2 coordinates"):
        targets_of({"door": [1, 2]})
