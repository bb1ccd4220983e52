"""Options that may be given only once: argparse would silently drop the first of two."""

import argparse


class Once(argparse.Action):
    """Stores the value of an argument, and refuses an option that was given before on the same command line."""

    _is_given = False

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: object,
        option_string: str | None = None,
    ) -> None:
        if option_string and self._is_given:
            parser.error(f"{option_string} is given twice; give it once")
        self._is_given = True
        setattr(namespace, self.dest, values)
