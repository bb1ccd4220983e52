"""What words alone say, without a recording (paper §3.2, §3.3)."""

from ..model import Analysis
from ..models import LanguageModels, Understudy
from ..rules.stage import find_functions as _find_functions
from ..rules.stage import find_functions_in_all

__all__ = ["find_functions", "find_functions_in_all"]


def find_functions(models: Understudy | LanguageModels, text: str) -> Analysis:
    """The communicative functions of the words alone (§3.2, §3.3); without a recording, nothing has a time.
    `LanguageModels` suffice.

    Raises InputError for a text that is too long or not well formed.
    """
    return _find_functions(models.language if isinstance(models, Understudy) else models, text)
