"""The label of a behaviour on its strip and in lists: "gesture: negation (right hand)", "gaze: listener"."""

_HANDS = {"left": "left hand", "right": "right hand", "both": "both hands"}
_DIRECTIONS = {
    "LEFT": "left",
    "RIGHT": "right",
    "UP": "up",
    "DOWN": "down",
    "UPLEFT": "up left",
    "UPRIGHT": "up right",
    "DOWNLEFT": "down left",
    "DOWNRIGHT": "down right",
}
_UNITS = {
    1: "inner brows up",
    2: "outer brows up",
    4: "brows together",
    5: "eyes wide",
    6: "cheeks up",
    7: "lids tight",
    9: "nose wrinkled",
    10: "upper lip up",
    12: "smile",
    14: "dimples",
    15: "mouth corners down",
    17: "chin up",
    20: "lips stretched",
    23: "lips tight",
    24: "lips pressed",
    25: "lips apart",
    26: "jaw down",
    43: "eyes closed",
    45: "blink",
}
"""Action units of the Facial Action Coding System, in plain words."""


def label_of(kind: str, lexeme: str, *, hand: str = "", target: str = "", direction: str = "") -> str:
    """The name of a behaviour. A gaze is called by what is looked at, or by the way that the eyes go from it; a gesture
    has its hand beside it."""
    if kind == "gaze" and (target or direction):
        return f"gaze: {_DIRECTIONS.get(direction.upper(), direction.lower()) or target}"
    plain = unit_name(lexeme) if lexeme.startswith("AU ") else lexeme.replace("_", " ").lower()
    return f"{kind}: {plain} ({_HANDS[hand]})" if kind == "gesture" and hand in _HANDS else f"{kind}: {plain}"


def unit_name(lexeme: str) -> str:
    """An action unit ("AU 12") in plain words, those unknown by their numbers."""
    number = lexeme.removeprefix("AU ")
    known = _UNITS.get(int(number), "") if number.isdecimal() else ""
    return f"{known} ({lexeme})" if known else lexeme
