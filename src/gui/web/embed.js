// In somebody else's page (?embed): messages between the two. README.md beside this file says which there are.
'use strict';

class Embedding {
  static version = 1;
  static most_link = 8000;       // letters; as the program's own bound
  static most_scene = 1 << 20;

  // `asked`: what stands behind ?embed=, the origin of the page around or nothing. `load_link`, `load_scene` and `go` do
  // what is asked for; `load_scene` returns why not, if it does not. `asks`: whether the program waits for an answer.
  constructor(asked, { load_link, load_scene, go, asks }) {
    Object.assign(this, { load_link, load_scene, go, asks, before: null, loading: true }); // its own link first
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
    // It hears of nothing else until then.
    if (message.do !== 'tell' && this.asks()) return 'a question is open: it has to be answered first';
    switch (message.do) {
      case 'load':
        if (text(message.link, Embedding.most_link) && message.link.includes('#v='))
          return this.begin_load(this.load_link(message.link));
        if (text(message.scene, Embedding.most_scene)) return this.begin_load(this.load_scene(message.scene));
        return 'load needs a link, "#v=1/...", or a scene, the text of a .toml';
      case 'go':
        if (Number.isInteger(message.step) && message.step >= 0 && message.step <= 1e9)
          return void this.go(message.step);
        return 'go needs a step, a whole number from 0 to 1e9';
      case 'tell':
        return void this.tell('moved', this.before.moment);
      default:
        return 'do must be "load", "go" or "tell"';
    }
  }

  // Until the next turn, and until what the program may ask first is answered, its errors are of this load.
  begin_load(why) {
    this.loading ||= !why;
    return why;
  }

  // After a turn, with what the program says of itself (page_told of main.cpp).
  look(now) {
    if (!this.before) this.tell('ready', now.moment);
    const before = this.before ?? { ...now, error: '' };
    this.before = now;
    if (JSON.stringify(before.moment) !== JSON.stringify(now.moment)) this.tell('moved', now.moment);
    const { lesson, lesson_step, lesson_steps } = before.moment;
    if (lesson && (now.moment.lesson || lesson) === lesson && now.judged > before.judged)
      this.tell('predicted', { lesson, lesson_step, right: now.right > before.right });
    if (now.made > before.made) this.tell('predicted', { step: now.moment.step, right: now.last_right });
    const ends = lesson_step === lesson_steps || !(before.done[lesson] >= lesson_steps); // a turn may see the last step left at once
    if (lesson && now.moment.lesson !== lesson && ends && now.done[lesson] >= lesson_steps)
      this.tell('finished', { lesson, right: now.right, judged: now.judged });
    // Others are about the student's own files, which are nobody else's business.
    if (this.loading && now.error && now.error !== before.error) this.tell('refused', { why: now.error });
    this.loading &&= now.asks;
  }
}
