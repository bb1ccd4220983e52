"""What holds for every interface: command line and service give the same bytes, formats and messages. Imports the
interfaces, `performance` and `support`. Begin with `test_lines.py`."""
