"""The rule language, the two stages that it runs, and the shipped rules. Facts are written by hand or come from the
shipped parser. Imports `understudy.rules` and `support`. Begin with `test_derivation.py`."""
