"""Those spoken to and what they do: `app/bml/choice/listeners`. Begin with `test_listening.py`."""
