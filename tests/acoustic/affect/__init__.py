"""How a voice sounds, mostly on synthetic signals: `app/acoustic/affect`. Begin with `test_affect_model.py`."""
