"""Names of a package that are imported at their first use (PEP 562), so that importing the package is cheap."""

from collections.abc import Callable, Collection, Sequence
from importlib import import_module
from sys import modules


def imported_on_first_use(package: str, names: Collection[str], homes: Sequence[str]) -> Callable[[str], object]:
    """The `__getattr__` of a package for its `names`: each is looked for in its modules `homes`, in this order, so that
    those that are cheap to import come first."""

    def found(name: str) -> object:
        if name in names:
            for home in homes:
                module = import_module(f".{home}", package)
                if hasattr(module, name):
                    value = getattr(module, name)
                    setattr(modules[package], name, value)
                    return value
        raise AttributeError(f"module {package!r} has no attribute {name!r}")

    return found
