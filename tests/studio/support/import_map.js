/** Lets node import the page's modules as a browser does, by the import map of its index.html. */

import { register } from "node:module";

register("./import_map_hooks.js", import.meta.url);
