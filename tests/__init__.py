"""The tests, in folders that mirror the package's: `app/acoustic/alignment/fit.py` is tested in
`tests/acoustic/alignment/test_fit.py`. What several tests need is in `support/`, tests through more than one interface
in `doors/`, the examples of the documentation in `docs/`, recordings in `audio/`. Tests import the package, `training`,
and `support`; those that need data outside the repository (`../shared`) are skipped without it. Begin with
`conftest.py`, which loads all of Understudy once, and `doors/test_lines.py`, where recorded lines pass through all
stages."""
