// Solves one case; the page ends the worker to stop it.

import { start } from "./ertel.js";

addEventListener("message", async ({ data: { module, text } }) => {
  try {
    const ertel = await start(module);
    const answer = ertel.solve(text, (event) => postMessage({ event }));
    postMessage({ answer });
  } catch (error) {
    postMessage({ answer: { ok: false, error: { text: String(error), internal: true } } });
  }
});
