// A worker: the same program without a window. It is told the compiled code, then messages with the files that the
// scene names, and posts what the program answers to each (worker.cpp).
'use strict';

if (typeof Raywalk === 'undefined') importScripts('raywalk.js');

async function begin(code) {
  const module = await Raywalk({
    noInitialRun: true,
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(code, imports).then((instance) => done(instance, code));
      return {};
    },
    preRun: [(module) => {
      module.FS.mkdir('/files');
      module.FS.chdir('/files');
    }],
  });
  return module;
}

function work(program, { bytes, files }) {
  for (const [path, content] of files) {
    program.FS.mkdirTree(path.slice(0, path.lastIndexOf('/')));
    program.FS.writeFile(path, content);
  }
  const room = program._worker_room(bytes.length); // may grow the memory: HEAPU8 is then another
  program.HEAPU8.set(bytes, room);
  const size = program._worker_work();
  if (size === 0) return;
  const at = program._worker_answer();
  const bytes_back = program.HEAPU8.slice(at, at + size);
  postMessage({ bytes: bytes_back, memory: program.HEAPU8.length }, [bytes_back.buffer]);
}

let program = null;
onmessage = ({ data }) => {
  program = data.code ? begin(data.code) : program.then((ready) => (work(ready, data), ready));
  program.catch((why) => setTimeout(() => { throw why; }));  // to the page, as an error of this worker
};
