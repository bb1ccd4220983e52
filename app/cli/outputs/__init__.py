"""The outputs of commands other than BML: listings, explanations, pictures of a line, motion files, the progress of a
batch. Imports `files` and `log`; drawing and realizing are imported on demand."""
