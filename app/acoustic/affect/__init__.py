"""How a line sounds: activation, valence, dominance and the shares of seven tones, of a line and of each phrase between
pauses (Bozkurt et al., *Affect-Expressive Hand Gestures*, §3, describe affect so). Imports `agitation`, whose features
it uses, and `signal`. Begin with `affect_model.py`, then `line_affect.py`, which also takes what an author gives
instead; `waveform_model.py` runs a user's own model. `training/affect` trains the models.
"""
