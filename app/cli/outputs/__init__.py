"""What commands tell people and write beside BML: listings, reasons, pictures of a line, files of motion, the progress
of a batch. Imports `files` and `log`; what is drawn or realized is imported when it is asked for.
"""
