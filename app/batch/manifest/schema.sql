-- One row a line. Times are seconds; `outputs`, `warnings` and `measures` are JSON.
CREATE TABLE IF NOT EXISTS lines (
    id TEXT PRIMARY KEY,
    place INTEGER NOT NULL,            -- in the script, from 0
    row INTEGER NOT NULL,              -- of the script's file
    character TEXT NOT NULL,           -- as the script names it
    performer TEXT NOT NULL,           -- our character
    text TEXT NOT NULL,
    comment TEXT NOT NULL,
    audio TEXT NOT NULL,               -- path of the recording
    start_s REAL, end_s REAL,          -- where it is cut out of a longer one
    input_hash TEXT NOT NULL,          -- recording, words, notes, who performs
    settings_hash TEXT NOT NULL,       -- formats, options, version, rules and models
    state TEXT NOT NULL CHECK (state IN ('waiting', 'done', 'failed')),
    outputs TEXT NOT NULL DEFAULT '[]',    -- [format, listener, path, bytes]
    warnings TEXT NOT NULL DEFAULT '[]',   -- [code, message]
    measures TEXT,
    error_code TEXT, error TEXT,
    seconds REAL
) WITHOUT ROWID;

-- Recordings whose content was hashed: it is not read again while size and time stay what they are.
CREATE TABLE IF NOT EXISTS recordings (
    path TEXT PRIMARY KEY,
    size INTEGER NOT NULL,
    modified_ns INTEGER NOT NULL,
    hash TEXT NOT NULL
) WITHOUT ROWID;
