"""A schedule in, motion out (paper §3.8), and the motion as files. The rooms, from the lowest: `geometry`, `body`,
`gestures`, `arms`, `face`, `torso`, `head_and_gaze`, `scheduling`, `mannequin`, `pictures` and `exporting`; each
imports only those named before it. From outside come the values, the errors, the version and `yaml_files` alone: a
realizer knows nothing of rules or of BML as text. Begin with `realizing.py`, which is §3.8 in order.
"""
