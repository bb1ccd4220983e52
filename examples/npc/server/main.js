/** `npm start`: runs the game until it is interrupted. */

import { optionsFrom, startGame } from "./game.js";

console.log("starting Understudy …");
const game = await startGame(optionsFrom(process.env));
console.log(`open ${game.url}`);

for (const signal of ["SIGINT", "SIGTERM"]) {
  process.once(signal, () => {
    void game.stop();
  });
}
