"""The behaviour realizer: from schedules to motion (paper §3.8) and motion files. The rooms, lowest first, are
`geometry`, `body`, `gestures`, `arms`, `face`, `torso`, `head_and_gaze`, `scheduling`, `mannequin`, `pictures` and
`exporting`; each imports only those before it. From the rest of the package only the data model, the errors, the
version and `yaml_files` are imported: the realizer does not depend on rules or on BML as text. Begin with
`realizing.py`, which applies the controllers in order."""
