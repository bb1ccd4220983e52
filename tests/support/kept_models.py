"""Models with the usual settings, loaded once in a process of tests, whoever loads them: most commands take less time
than what they load. Tests of loading load their own, by other settings or from other files."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from threadpoolctl import threadpool_limits

from understudy import models as loading
from understudy.files import RULES
from understudy.loading import OnDemand
from understudy.models import Understudy
from understudy.settings import Settings


@contextmanager
def models_kept() -> Iterator[None]:
    """Until the block ends `Understudy.load` and `for_words` give the same models wherever the usual ones are wanted,
    which closing leaves as they are."""
    usual, load, for_words, close = Settings(), Understudy.load, Understudy.for_words, Understudy.close
    kept = OnDemand(lambda: for_words(usual))

    def are_wanted(settings: Settings) -> bool:
        return settings == usual and vars(loading)["RULES"] == RULES

    def load_or_give(settings: Settings) -> Understudy:
        if not are_wanted(settings):
            return load(settings)
        threadpool_limits(limits=1, user_api="blas")
        kept.get().when_hearing.get()
        return kept.get()

    def close_others(models: Understudy) -> None:
        if models is not kept.made():
            close(models)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Understudy, "load", load_or_give)
        patch.setattr(Understudy, "for_words", lambda each: kept.get() if are_wanted(each) else for_words(each))
        patch.setattr(Understudy, "close", close_others)
        yield
    whole = kept.made()
    if whole is not None:
        whole.close()
