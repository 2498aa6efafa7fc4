// Unpacks the program's code as it arrives, so that the browser compiles the beginning while the rest comes. What does it is
// a module of its own (unpack.cpp), which pack.mjs fills in here.
'use strict';

function bytes_of(letters) {
  const text = atob(letters), bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// The code, of a stream of packed bytes. Whoever reads it hears of an error of the network if it cannot be unpacked: `refused`
// hears why.
async function unpacked(packed, refused = () => {}) {
  const { instance: { exports: tool } } = await WebAssembly.instantiate(
    Uint8Array.from('UNPACKER'.match(/../g), (digits) => parseInt(digits, 16)));
  tool._initialize();
  const most = tool.unpack_most();
  let done = 0;
  const refuse = (text) => {
    const why = new Error(text);
    refused(why);
    throw why;
  };
  const unpacking = new TransformStream({
    transform(bytes, code) {
      for (let from = 0; from < bytes.length; from += most) {
        const part = bytes.subarray(from, from + most);
        new Uint8Array(tool.memory.buffer).set(part, tool.unpack_room());
        const now = tool.unpack(part.length);
        if (now < 0) refuse(now === -2 ? 'out of memory' : 'the page has arrived damaged');
        if (now > done) code.enqueue(new Uint8Array(tool.memory.buffer).slice(tool.unpack_code() + done, tool.unpack_code() + now));
        done = now;
      }
    },
    flush() {
      if (!tool.unpack_whole()) refuse('the page has not arrived whole');
    },
  });
  return new Response(packed.pipeThrough(unpacking), { headers: { 'Content-Type': 'application/wasm' } });
}
