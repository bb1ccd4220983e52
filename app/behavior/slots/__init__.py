"""Slots from the words of a line: how high, how big, how many, on which side, which one (docs/slots.md). `patterns`
match words, `table` has the authors' file, `findings` what a line says, `places` keeps referents in place and contrasts
apart, `gestures` gives each gesture its own."""
