// Fingers: one points, presses and drags as a mouse does, or scrolls what scrolls; held still it tells what hovering would;
// two zoom and pan. A field of the program's gets the system's keyboard, by a field of the page's that nobody sees.
'use strict';

class Touch {
  static still = 8;        // pixels that a finger at rest may move
  static long_press = 500; // milliseconds

  // `holds`: whether what is there is held down to repeat; `scroll` moves what is there with the finger, if it scrolls;
  // `wheel` turns the program's wheel; `first` is called once.
  constructor(canvas, { holds, scroll, wheel, first, settle }) {
    Object.assign(this, { canvas, holds, scroll, wheel, first, settle });
    this.finger = null; // the one that points: where it went down, and whether it presses or scrolls
    this.two = null;    // their middle and distance
    for (const type of ['touchstart', 'touchmove', 'touchend', 'touchcancel'])
      window.addEventListener(type, (event) => event.target === canvas && this.take(event), { capture: true, passive: false });
  }

  take(event) {
    event.preventDefault();
    event.stopImmediatePropagation(); // GLFW would press at once
    this.first?.();
    this.first = null;
    const fingers = [...event.targetTouches];
    if (fingers.length >= 2) return this.pinch(fingers);
    if (this.two) {
      if (fingers.length === 0) this.end_pinch();
      return;
    }
    if (event.type === 'touchstart') return this.begin(fingers[0], event.timeStamp);
    if (!this.finger) return;
    if (event.type === 'touchmove') return this.move(fingers[0]);
    this.end(event.type === 'touchend', event.timeStamp);
  }

  mouse(type, { x, y }, button = 0) {
    this.canvas.dispatchEvent(new MouseEvent(type, { clientX: x, clientY: y, button, bubbles: true, cancelable: true }));
  }
  press(down, at, button = 0) {
    this.mouse(down ? 'mousedown' : 'mouseup', at, button);
  }

  // Times are the events' own: a busy page hears of them late.
  begin(touch, time) {
    const at = { x: touch.clientX, y: touch.clientY };
    this.finger = { at, now: at, since: time, presses: false, scrolls: false };
    this.mouse('mousemove', at);
    if (this.holds(at.x, at.y)) this.press_finger();
  }
  press_finger() {
    this.finger.presses = true;
    this.press(true, this.finger.at);
  }
  move(touch) {
    const finger = this.finger, before = finger.now;
    finger.now = { x: touch.clientX, y: touch.clientY };
    const right = finger.now.x - finger.at.x, down = finger.now.y - finger.at.y;
    if (!finger.presses && !finger.scrolls && Math.hypot(right, down) > Touch.still) {
      finger.scrolls = Math.abs(down) > Math.abs(right) && this.scroll(finger.at.x, finger.at.y, down);
      if (!finger.scrolls) this.press_finger();
    } else if (finger.scrolls) {
      this.scroll(finger.at.x, finger.at.y, finger.now.y - before.y);
    }
    if (finger.presses || finger.scrolls) this.mouse('mousemove', finger.now);  // which has it drawn
  }
  end(lifted, time) {
    const finger = this.finger;
    this.finger = null;
    const told = !finger.presses && !finger.scrolls && time - finger.since > Touch.long_press;
    if (!finger.presses && !finger.scrolls && !told && lifted) this.press(true, finger.at);
    if (!told && !finger.scrolls) {
      this.press(false, finger.now);
      this.settle();
    }
    // Nothing is pointed at any more; but what was told stays to be read.
    if (!told) setTimeout(() => this.finger || this.two || this.mouse('mousemove', { x: -9, y: -9 }), 100);
  }

  // Two fingers drag with the middle button, which pans, and turn the wheel.
  pinch([one, other]) {
    const now = { x: (one.clientX + other.clientX) / 2, y: (one.clientY + other.clientY) / 2 };
    const apart = Math.max(Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY), 1);
    if (!this.two && this.finger?.presses) {
      // It lets go where it is, before the middle is pointed at: what it drags or draws stays there.
      this.press(false, this.finger.now);
      this.settle();
    }
    this.mouse('mousemove', now);
    if (!this.two) {
      this.finger = null;
      this.two = { now, apart };
      this.press(true, now, 1);
      return;
    }
    this.wheel(Math.log(apart / this.two.apart) / Math.log(1.2));
    this.two = { now, apart };
  }
  end_pinch() {
    this.press(false, this.two.now, 1);
    this.two = null;
    setTimeout(() => this.finger || this.two || this.mouse('mousemove', { x: -9, y: -9 }), 100);
  }
}

class Keyboard {
  // Something to delete, for a system's keyboard says nothing of a key that has nothing to do.
  static something = '\u200b\u200b';

  constructor(canvas, { settle }) {
    this.canvas = canvas;
    this.field = Object.assign(document.createElement('input'), { type: 'text', id: 'keyboard', autocomplete: 'off', tabIndex: -1 });
    this.field.setAttribute('autocapitalize', 'off');
    canvas.after(this.field);
    // Not every browser does so when its keyboard comes, or grows.
    window.visualViewport?.addEventListener('resize', () =>
      document.activeElement === this.field && this.field.scrollIntoView({ block: 'nearest' }));
    this.reset();
    this.settle = settle;
    this.field.addEventListener('input', ({ inputType, isComposing }) => {
      if (isComposing || this.composed.length > 0) this.compose();
      else if (inputType.startsWith('delete')) this.key(8, 'Backspace');
      else this.type(this.own());
      if (!isComposing) this.reset();
      settle();
    });
    this.field.addEventListener('compositionend', () => {
      this.compose();
      this.reset();
    });
  }
  own() {
    return this.field.value.replaceAll('\u200b', '');
  }
  // Letters that are composed are typed as they stand there, and taken back where others take their place.
  compose() {
    const now = [...this.own()];
    let same = 0;
    while (same < this.composed.length && this.composed[same] === now[same]) ++same;
    for (let i = same; i < this.composed.length; ++i) this.key(8, 'Backspace');
    this.type(now.slice(same).join(''));
    this.composed = now;
    this.settle();
  }
  reset() {
    this.composed = [];
    this.field.value = Keyboard.something;
    this.field.setSelectionRange(2, 2);
  }
  send(type, more) {
    this.canvas.dispatchEvent(new KeyboardEvent(type, { ...more, bubbles: true, cancelable: true }));
  }
  // A key has turns of its own, which see it pressed and released: within one the program takes it after the letters, and
  // but once.
  key(keyCode, key) {
    for (const type of ['keydown', 'keyup']) this.send(type, { key, keyCode });
    for (let i = 0; i < 2; ++i) this.settle();
  }
  type(text) {
    for (const letter of text) this.send('keypress', { key: letter, charCode: letter.codePointAt(0) });
  }
  // In the event of a finger: later a browser would not show it. `wanted`: its kind (an inputmode), and where the program's
  // field is: this one stands there, so that the browser keeps that in sight beside the keyboard; or false.
  show(wanted) {
    if (wanted) {
      this.field.inputMode = wanted.mode;
      Object.assign(this.field.style, { left: `${wanted.x}px`, top: `${wanted.y}px` });
      this.field.focus();
    } else if (document.activeElement === this.field) this.canvas.focus();
  }
}
