"""What commands show people and write beside BML: listings, reasons, pictures of a line, files of motion, the progress
of a batch. Imports `files` and `log`; drawing and realizing are imported on demand."""
