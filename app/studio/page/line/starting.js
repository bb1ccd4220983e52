/** Whether the author is choosing what to open, while a line may be open behind it. */

import { slice } from "../state/slice.js";

export const STARTING = slice(false);
