"""What the words of a line could mean for hands, head and face: `app/behavior/reading`. Begin with
`test_planning.py`."""
