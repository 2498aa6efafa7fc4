// Sorts what instructions are made of for what packs them: all opcodes, all locals, all offsets and so on stand beside each
// other, where each is foretold by its like. joiner.h, which puts them together again, says how. Its texts are taken out, for
// another packer.
const code_section = 10;
const block_size = 9 << 18; // of code, half of it: a browser compiles one while the next arrives

// The numbers of the streams, as in joiner.h.
const declarations = 0, opcodes = 1, local = 2, local_set = 3, small = 4, added = 5, large = 6, i64 = 7, f32 = 8, f64 = 9,
  vectors = 10, called = 11, called_by_pointer = 12, branches = 13, branch_tables = 14, others = 15, loaded = 16, stored = 17,
  lanes_offset = 18, lanes_align = 19, align = 20, streams = align + 0x3f - 0x28;
const large_constant = 0x27; // not an opcode
const most_locals = 1 << 14; // of a function, as in joiner.h
const texts_like = /(?:[\0\t\n -~]|[\xc2-\xef][\x80-\xbf]+){1024,}/g; // UTF-8; a text in C++ ends with 0

export function streamed(wasm) {
  let at = 8;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = wasm[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  const words = (...values) => Buffer.from(Uint32Array.from(values).buffer);
  const parts = [], texts = [];
  const plain = (from, to, end = to) => {
    parts.push(words(0, to - from, end - to), wasm.subarray(from, to));
    texts.push(wasm.subarray(to, end));
  };

  let sorted, functions, from;
  const begin = () => {
    sorted = Array.from({ length: streams }, () => []);
    functions = 0;
    from = at;
  };
  const end = () => {
    if (functions === 0) return;
    parts.push(words(functions, ...sorted.map(({ length }) => length)), ...sorted.map((bytes) => Buffer.from(bytes)));
    begin();
  };
  const put = (stream, count) => {
    for (; count > 0; --count) sorted[stream].push(wasm[at++]);
  };
  const put_number = (stream) => {
    const begun = at;
    number();
    const count = at - begun;
    at = begun;
    put(stream, count);
  };
  const put_numbers = (stream, more) => {
    const begun = at, count = number() + more;
    at = begun;
    put_number(stream);
    for (let i = 0; i < count; ++i) put_number(stream);
  };
  // A local that is read is told by how many others were named since it was: code that is alike differs in their numbers.
  let recent;
  const name_local = (index) => {
    if (index >= most_locals) throw new Error('a function has more locals than joiner.h takes');
    while (recent.length <= index) recent.push(recent.length);
    const rank = recent.indexOf(index);
    recent.splice(rank, 1);
    recent.unshift(index);
    return rank;
  };
  const put_rank = () => {
    let rank = name_local(number());
    for (; rank > 127; rank >>= 7) sorted[local].push((rank & 127) | 128);
    sorted[local].push(rank);
  };
  const put_local_set = () => {
    const begun = at;
    name_local(number());
    at = begun;
    put_number(local_set);
  };
  const locals = () => {
    recent = [];
    const begun = at;
    let groups = number();
    at = begun;
    put_number(declarations);
    for (; groups > 0; --groups) {
      put_number(declarations); // how many
      put(declarations, 1); // of what type
    }
  };
  const instruction = () => {
    const op = wasm[at];
    if (op === large_constant) throw new Error('an instruction has the code that is kept for large constants');
    if (op === 0x41) { // i32.const
      ++at;
      const begun = at;
      number();
      const is_large = at - begun > 2, is_added = wasm[at] === 0x6a; // i32.add comes next
      at = begun;
      sorted[opcodes].push(is_large ? large_constant : op);
      return put_number(is_large ? large : is_added ? added : small);
    }
    put(opcodes, 1);
    if (op >= 0x28 && op <= 0x3e) {
      put_number(align + op - 0x28);
      return put_number(op >= 0x36 ? stored : loaded);
    }
    switch (op) {
      case 0x02: case 0x03: case 0x04: case 0x06: return put_number(opcodes); // block, loop, if, try: a type
      case 0x0c: case 0x0d: case 0x09: case 0x18: return put_number(branches); // br, br_if, rethrow, delegate
      case 0x0e: return put_numbers(branch_tables, 1); // br_table
      case 0x10: return put_number(called);
      case 0x11: put_number(called_by_pointer); return put_number(called_by_pointer);
      case 0x1c: return put_numbers(opcodes, 0); // select with types
      case 0x20: return put_rank(); // local.get
      case 0x21: case 0x22: return put_local_set(); // local.set, local.tee
      case 0x07: case 0x08: // catch, throw
      case 0x23: case 0x24: case 0x25: case 0x26: // global.get to table.set
      case 0x3f: case 0x40: case 0xd0: case 0xd2: return put_number(others); // memory.size, memory.grow, ref.null, ref.func
      case 0x42: return put_number(i64);
      case 0x43: return put(f32, 4);
      case 0x44: return put(f64, 8);
      case 0xfc: {
        const more = wasm[at];
        put(opcodes, 1);
        if (more === 10) return put(others, 2); // memory.copy
        if (more === 11) return put(others, 1); // memory.fill
        if (more > 7) throw new Error(`instruction 0xfc ${more} is not known here`);
        return;
      }
      case 0xfd: {
        const begun = at, more = number();
        at = begun;
        put_number(opcodes);
        const names_lane = more >= 84 && more <= 91;
        if (more <= 11 || names_lane || more === 92 || more === 93) put_number(lanes_align), put_number(lanes_offset);
        if (more === 12 || more === 13) put(vectors, 16); // v128.const, i8x16.shuffle
        if ((more >= 21 && more <= 34) || names_lane) put(others, 1);
        return;
      }
      case 0xfe: case 0x12: case 0x13: throw new Error(`instruction ${op} is not known here`);
    }
  };

  while (at < wasm.length && wasm[at] !== code_section) {
    ++at;
    const size = number();
    at += size;
  }
  ++at;
  number(); // its size
  let left = number();
  plain(0, at);
  for (begin(); left > 0; --left) {
    if (at - from > block_size) end();
    const size = number(), after = at + size;
    locals();
    while (at < after) instruction();
    if (at !== after) throw new Error('a function does not end with an instruction');
    ++functions;
  }
  end();
  const data = at;
  for (const { 0: text, index } of wasm.toString('latin1', data).matchAll(texts_like)) {
    plain(at, data + index, data + index + text.length);
    at = data + index + text.length;
  }
  plain(at, wasm.length);
  return { parts: Buffer.concat(parts), texts: Buffer.concat(texts) };
}
