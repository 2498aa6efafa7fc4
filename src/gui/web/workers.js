// The workers of the page: as many as make sense, begun when the program first asks for them, each with the program's code;
// and their answers until the program takes them. Where a browser refuses them, or one of them fails, there are none.
'use strict';

class PageWorkers {
  static most = 2;  // each has a memory of its own

  // `address`: of worker.js, where that is not in this file. `answered` is called after each answer. `files`: the user's, each
  // a path and its bytes; `changed` counts changes.
  constructor(code, address, { answered, files, changed }) {
    Object.assign(this, { code, address, answered, files, changed, answers: [], all: null });
  }

  begin_all() {
    this.all = [];
    try {
      const many = Math.min(PageWorkers.most, Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1));
      for (let i = 0; i < many; ++i) this.all.push(this.begin(i));
    } catch (why) {
      this.lose(why);
    }
  }

  begin(number) {
    const letters = document.getElementById('worker')?.textContent;
    let { address } = this;
    if (letters) {
      const program = document.getElementById('program').textContent;
      address = URL.createObjectURL(new Blob([program, '\n', letters], { type: 'text/javascript' }));
    } else if (self.origin === 'null') {
      throw new Error('a frame without an origin may load none');
    }
    const worker = new Worker(address);
    worker.seen = 0;  // changes of the files
    worker.onmessage = ({ data: { bytes, memory } }) => {
      worker.memory = memory;
      this.answers.push({ worker: number, bytes });
      this.answered();
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.lose(event.message);
    };
    worker.postMessage({ code: this.code });
    return worker;
  }

  lose(why) {
    console.warn('the page works without workers:', why);
    for (const worker of this.all) worker.terminate();
    this.all = [];
    this.answers = [];
    this.answered();
  }

  // Of all, in bytes.
  memory() {
    return (this.all ?? []).reduce((sum, { memory }) => sum + (memory ?? 0), 0);
  }

  // What the program asks for (platform.cpp).
  count() {
    if (!this.all) this.begin_all();
    return this.all.length;
  }
  tell(number, bytes) {
    const worker = this.all[number];
    if (!worker) return;
    const changes = this.changed(), files = worker.seen === changes ? [] : this.files();
    worker.seen = changes;
    worker.postMessage({ bytes, files }, [bytes.buffer]);
  }
  // The kind of an answer is its first byte.
  next(kind) {
    return this.answers.find(({ bytes }) => bytes[0] === kind);
  }
  take(kind) {
    return this.answers.splice(this.answers.findIndex(({ bytes }) => bytes[0] === kind), 1)[0];
  }
}
