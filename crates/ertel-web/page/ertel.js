// The WebAssembly module as functions: texts in, objects out. Used by the page, its worker and the tests alike.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** The functions of a compiled module, a separate instance for each call. */
export async function start(module) {
  let exports;
  let answer = null;
  let panic = "";
  let progress = () => {};
  const text = (address, length) =>
    decoder.decode(new Uint8Array(exports.memory.buffer, address, length));
  const imports = {
    ertel: {
      ertel_answer: (address, length) => { answer = text(address, length); },
      ertel_progress: (address, length) => progress(JSON.parse(text(address, length))),
      ertel_panic: (address, length) => { panic = text(address, length); },
      ertel_seconds: () => performance.now() / 1000,
    },
  };
  ({ exports } = await WebAssembly.instantiate(module, imports));

  function call(name, ...texts) {
    answer = null;
    panic = "";
    try {
      const places = texts.flatMap((one) => {
        const bytes = encoder.encode(one);
        const address = exports.text_room(bytes.length) >>> 0;
        new Uint8Array(exports.memory.buffer, address, bytes.length).set(bytes);
        return [address, bytes.length];
      });
      exports[name](...places);
    } catch (error) {
      const reason = panic || String(error);
      return { ok: false, error: { text: `the solver stopped with an internal error: ${reason}`, internal: true } };
    }
    return JSON.parse(answer);
  }

  return {
    database: () => call("database"),
    form: (caseText) => call("form", caseText),
    edit: (caseText, changes) => call("edit", caseText, JSON.stringify(changes)),
    check: (caseText) => call("check", caseText),
    solve(caseText, onProgress = () => {}) {
      progress = onProgress;
      return call("solve", caseText);
    },
    memory: () => exports.memory.buffer.byteLength,
  };
}
