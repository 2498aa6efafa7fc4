// Lets the browser keep the page for when there is no network (kept.js), where it stands on a host that allows it.
'use strict';

if (document.querySelector('link[rel=manifest]') && self.origin !== 'null' && navigator.serviceWorker)
  window.addEventListener('load', () => navigator.serviceWorker.register('kept.js', { updateViaCache: 'none' })
    .then((registration) => { self.keeper = registration; }) // Firefox loses an installing worker that nobody holds
    .catch((why) => console.warn('the page is not kept for when there is no network:', why)));
