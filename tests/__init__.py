"""The tests, in folders that mirror the package's: what `app/acoustic/alignment/fit.py` does is tested in
`tests/acoustic/alignment/test_fit.py`. What several tests need is in `support/`, what goes through more than one door
in `doors/`, the examples of the documentation in `docs/`, recordings in `audio/`. Tests import the package, `training`,
and each other's `support`; those that need data beside the repository (`../shared`) are skipped without it. Begin with
`conftest.py`, which loads the whole of Understudy once, and `doors/test_lines.py`, where recorded lines go all the way.
"""
