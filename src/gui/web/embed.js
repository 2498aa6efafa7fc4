// In somebody else's page (?embed): messages between the two. README.md beside this file says which there are.
'use strict';

class Embedding {
  static version = 1;
  static most_link = 8000;       // letters; as the program's own bound
  static most_scene = 1 << 20;

  // `asked`: what stands behind ?embed=, the origin of the page around or nothing. `load_link`, `load_scene` and `go` do
  // what is asked for; `load_scene` returns why not, if it does not, else what is kept once it has.
  constructor(asked, { load_link, load_scene, go }) {
    Object.assign(this, { load_link, load_scene, go, before: null, loading: true, loaded: true }); // its own link first
    this.origin = asked ? Embedding.origin_of(asked) : null;
    window.addEventListener('message', (event) => this.hear(event));
  }

  // Empty, which nobody's is, for what names none.
  static origin_of(address) {
    const { protocol, origin } = URL.canParse(address) ? new URL(address) : {};
    return protocol === 'https:' || protocol === 'http:' ? origin : '';
  }

  tell(event, more = {}) {
    // Nothing but what the frame shows is told. Without a named origin it may be any: a sandbox has none to name.
    if (window.parent !== window && this.origin !== '') window.parent.postMessage({ raywalk: Embedding.version, event, ...more }, this.origin ?? '*');
  }

  hear({ source, origin, data }) {
    if (source !== window.parent || source === window || (this.origin !== null && origin !== this.origin)) return;
    if (typeof data !== 'object' || data === null || !('raywalk' in data)) return; // of somebody else's
    const why = this.obey(data);
    if (why) this.tell('refused', { why });
  }

  // Does what a message asks for; or what is wrong with it.
  obey(message) {
    const text = (value, most) => typeof value === 'string' && value.length > 0 && value.length <= most;
    if (!this.before) return 'the page is not ready yet: wait for its message "ready"';
    if (message.raywalk !== Embedding.version) return `raywalk must be ${Embedding.version}, the version of these messages`;
    switch (message.do) {
      case 'load':
        if (text(message.link, Embedding.most_link) && message.link.includes('#v='))
          return this.await_load(() => this.load_link(message.link));
        if (text(message.scene, Embedding.most_scene)) return this.await_load(() => this.load_scene(message.scene));
        return 'load needs a link, "#v=1/...", or a scene, the text of a .toml';
      case 'go':
        if (Number.isInteger(message.step) && message.step >= 0 && message.step < 2 ** 31) return void this.go(message.step);
        return 'go needs a step, a whole number from 0 on';
      case 'tell':
        return void this.tell('moved', this.before.moment);
      default:
        return 'do must be "load", "go" or "tell"';
    }
  }

  // Until it is loaded, and the student has answered what the program may ask first, its errors are of this load.
  await_load(begin) {
    const begun = begin();
    if (typeof begun === 'string' && begun) return begun;
    this.loading = true;
    this.loaded = false;
    Promise.resolve(begun).then(() => { this.loaded = true; });
    return undefined;
  }

  // After a turn, with what the program says of itself (page_told of main.cpp).
  look(now) {
    if (!this.before) this.tell('ready', now.moment);
    const before = this.before ?? { ...now, error: '' };
    this.before = now;
    if (JSON.stringify(before.moment) !== JSON.stringify(now.moment)) this.tell('moved', now.moment);
    if (now.judged > before.judged)
      this.tell('predicted', { lesson: now.moment.lesson, lesson_step: now.moment.lesson_step, right: now.right > before.right });
    if (now.made > before.made) this.tell('predicted', { step: now.moment.step, right: now.last_right });
    const { lesson, lesson_step, lesson_steps } = before.moment;
    if (lesson && now.moment.lesson !== lesson && lesson_step === lesson_steps && now.done[lesson] >= lesson_steps)
      this.tell('finished', { lesson, right: now.right, judged: now.judged });
    // Others are about the student's own files, which are nobody else's business.
    if (this.loading && now.error && now.error !== before.error) this.tell('refused', { why: now.error });
    if (this.loaded && !now.asks) this.loading = this.loaded = false;
  }
}
