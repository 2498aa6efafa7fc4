// The window in words, for those who do not see the canvas or do not point: the program's outline (gui/mirror.h) as
// elements of the page, beside the canvas. It is made once somebody asks for it by the page's first button.
'use strict';

class Mirror {
  // `ask`: the outline as JSON; `act`: does what an item does, with what was typed, and returns what is wrong; `shown` is
  // called after it is shown or hidden.
  constructor(place, { ask, act, shown }) {
    Object.assign(this, { place, ask, act, shown, last: '' });
    this.open = false;
  }

  show(open) {
    this.open = open;
    this.place.hidden = !open;
    this.last = '';
    this.refresh();
    this.shown();
  }

  // After a turn of the program.
  refresh() {
    if (!this.open) return;
    const now = this.ask();
    if (now === this.last) return;
    const told = this.last;
    this.last = now;
    this.news = [];
    this.fill(this.place.querySelector('.outline'), JSON.parse(now));
    // Of what comes with its text screen readers say nothing: this was there before.
    if (told && this.news.length > 0) Mirror.say(this.place.querySelector('.unseen[role]'), this.news.join('\n'));
  }

  // Makes the children of an element those that the items stand for. What stays keeps its element, and so the focus.
  fill(parent, items) {
    const key_of = (item) => `${item.role} ${item.key}`;
    const wanted = new Set(items.map(key_of)), kept = new Map;
    for (const child of [...parent.children].filter((each) => each.dataset.key)) {
      if (wanted.has(child.dataset.key)) {
        kept.set(child.dataset.key, child);
        continue;
      }
      if (child.contains(document.activeElement)) this.keep_focus(child);
      child.remove();
    }
    let at = [...parent.children].find((child) => child.dataset.key) ?? null;
    for (const item of items) {
      const key = key_of(item);
      let element = kept.get(key);
      if (!element) {
        element = Mirror.makers[item.role](this);
        element.dataset.key = key;
      }
      if (element === at) at = at.nextElementSibling;
      else parent.insertBefore(element, at);
      element.tell(item);
    }
  }

  // What a button opens stands far from it: the focus goes there. What is folded is opened only here.
  press(button, { does, to }) {
    const regions = () => [...this.place.querySelectorAll('.outline > section')];
    const named = () => regions().find((each) => each.dataset.key === 'region ' + to);
    const folded = to && named()?.querySelector('details');
    if (folded) {
      folded.open = true;
      return folded.querySelector('h2').focus();
    }
    const before = new Set(regions());
    this.act(does, '');
    const opened = to ? named() : button.dataset.key.startsWith('button command-') && regions().find((each) => !before.has(each));
    if (opened) opened.querySelector('h2').focus();
  }

  // The focus of what goes away goes to what stands before it, and not to the start of the page.
  keep_focus(gone) {
    const all = [...this.place.querySelectorAll('button:not([aria-disabled=true]), input, summary, h1, h2')];
    const before = all.filter((each) => !gone.contains(each) && gone.compareDocumentPosition(each) & Node.DOCUMENT_POSITION_PRECEDING);
    (before.at(-1) ?? this.place.querySelector('h1')).focus();
  }

  static set(element, name, value) {
    if (value === null || value === undefined) element.removeAttribute(name);
    else if (element.getAttribute(name) !== String(value)) element.setAttribute(name, value);
  }
  static say(element, text) {
    if (element.textContent !== text) element.textContent = text;
  }
  static make(tag, more = {}) {
    return Object.assign(document.createElement(tag), more);
  }

  static words(role, news) {
    return (mirror) => {
      const element = Mirror.make('p');
      Mirror.set(element, 'role', role);
      element.tell = (item) => {
        if (news && element.textContent !== item.name) mirror.news.push(item.name);
        Mirror.say(element, item.name);
      };
      return element;
    };
  }

  // Safari takes one without marks for none, unless it is told.
  static list() {
    const list = Mirror.make('ol');
    list.setAttribute('role', 'list');
    return list;
  }

  // `takes`: with a button that sends what stands there, even as it came; else it is sent when it is changed.
  static field(takes) {
    return (mirror) => {
      const element = Mirror.make(takes ? 'form' : 'div', { className: 'field' });
      const label = Mirror.make('label'), input = Mirror.make('input', { type: 'text', autocomplete: 'off' });
      const wrong = Mirror.make('span', { className: 'wrong' });
      wrong.setAttribute('role', 'alert');
      input.id = `field-${++Mirror.fields}`;
      wrong.id = input.id + '-wrong';
      label.htmlFor = input.id;
      const button = takes && Mirror.make('button');
      element.append(label, input, ...(takes ? [button] : []), wrong);
      let last = {}, shown = '';
      const show = () => { input.value = shown = last.value; };
      const send = () => {
        const text = takes || input.value !== shown ? mirror.act(last.does, input.value) : '';
        Mirror.say(wrong, text);
        Mirror.set(input, 'aria-invalid', text ? true : null);
        Mirror.set(input, 'aria-describedby', text ? wrong.id : null);
        if (!text && !takes) show();
      };
      if (takes) {
        button.addEventListener('click', (event) => { // Enter is one, too
          event.preventDefault();
          send();
        });
      } else {
        input.addEventListener('change', send); // Enter is one, too
        input.addEventListener('blur', () => !wrong.textContent && show());
      }
      element.tell = (item) => {
        const differs = item.value !== last.value;
        last = item;
        Mirror.say(label, item.name);
        if (takes) Mirror.say(button, item.hint);
        if (differs && document.activeElement !== input) show();
      };
      return element;
    };
  }
  static fields = 0;

  static makers = {
    region: (mirror) => {
      const element = Mirror.make('section'), heading = Mirror.make('h2', { tabIndex: -1 });
      heading.id = `region-${++Mirror.fields}`;
      element.setAttribute('aria-labelledby', heading.id);
      let within = null;
      element.tell = (item) => {
        if (!within) {
          if (item.folded) {
            within = Mirror.make('details');
            const summary = Mirror.make('summary');
            summary.append(heading);
            within.append(summary);
          } else {
            within = Mirror.make('div');
            within.append(heading);
          }
          element.append(within);
        }
        Mirror.say(heading, item.name);
        mirror.fill(within, item.items ?? []);
      };
      return element;
    },
    text: Mirror.words(),
    news: Mirror.words(null, true),
    warning: Mirror.words('alert'),
    list: (mirror) => {
      const element = Mirror.make('div'), name = Mirror.make('h3'), list = Mirror.list();
      name.id = `list-${++Mirror.fields}`;
      list.setAttribute('aria-labelledby', name.id);
      element.append(name, list);
      element.tell = (item) => {
        Mirror.say(name, item.name);
        // It names the list all the same.
        name.hidden = element.closest('section').querySelector('h2').textContent === item.name;
        mirror.fill(list, item.items ?? []);
        list.hidden = !item.items;
      };
      return element;
    },
    entry: (mirror) => {
      const element = Mirror.make('li'), name = Mirror.make('span');
      element.append(name);
      let list = null, rest = null;
      element.tell = (item) => {
        Mirror.say(name, item.name);
        Mirror.set(element, 'aria-current', item.current ? 'step' : null);
        const items = item.items ?? [];
        const entries = items.filter((each) => each.role === 'entry'), others = items.filter((each) => each.role !== 'entry');
        if (others.length > 0 && !rest) element.insertBefore(rest = Mirror.make('div'), name.nextSibling);
        if (rest) mirror.fill(rest, others);
        if (entries.length > 0 && !list) element.append(list = Mirror.list());
        if (list) mirror.fill(list, entries);
        if (list && entries.length === 0) list = list.remove() ?? null;
      };
      return element;
    },
    button: (mirror) => {
      const element = Mirror.make('button', { type: 'button' });
      let last = {};
      element.addEventListener('click', () => element.getAttribute('aria-disabled') !== 'true' && mirror.press(element, last));
      element.tell = (item) => {
        Mirror.say(element, item.name);
        last = item;
        Mirror.set(element, 'title', item.hint && item.hint !== item.name ? item.hint : null);
        // It keeps the focus while it is of no use.
        Mirror.set(element, 'aria-disabled', item.enabled === false ? true : null);
        Mirror.set(element, 'aria-pressed', item.chosen === undefined ? null : item.chosen);
      };
      return element;
    },
    number: Mirror.field(false),
    words: Mirror.field(false),
    path: Mirror.field(true),
  };
}
