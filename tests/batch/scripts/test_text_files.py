"""Text files in various encodings: the same words are read, and a guess is reported."""

import pytest

from understudy.batch.scripts.text_files import decode_text
from understudy.errors import UndecodableError

TEXT = "Señor Müller said: “No — never.” £5, déjà vu."


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-32"])
def test_unicode_is_known_for_certain(encoding: str) -> None:
    file = decode_text(TEXT.encode(encoding), "lines.csv")
    assert (file.text, file.remark) == (TEXT, "")


def test_a_guess_is_told() -> None:
    file = decode_text(TEXT.encode("cp1252"), "lines.csv")
    assert file.text == TEXT
    assert "lines.csv" in file.remark
    assert "cp1252" in file.remark


def test_other_scripts_are_judged_by_their_letters() -> None:
    russian = "Здравствуйте, это проверка кодировки текста, в котором достаточно слов для статистики."
    assert decode_text(russian.encode("cp1251"), "lines.csv").text == russian


def test_what_is_no_text_is_refused() -> None:
    with pytest.raises(UndecodableError) as raised:
        decode_text(b"\xff\xfe\x00", "lines.csv")
    assert raised.value.code == "text_not_utf8"
