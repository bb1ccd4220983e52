"""BML with almost no movement, which is realized to obtain a character's body."""

_STILL = (
    '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="bml1" characterId="{character}">'
    '<head id="head1" lexeme="NOD" amount="0" start="0" end="0.5"/></bml>'
)


def still_bml(character: str) -> bytes:
    """The BML, whose character is named."""
    return _STILL.format(character=character).encode()
