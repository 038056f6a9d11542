// The studio's page.

import '@fontsource-variable/inter';
import './ui/styles/tokens.css';
import './ui/styles/base.css';
import './ui/styles/panels.css';
import './ui/styles/messages.css';
import './ui/styles/layout_floating.css';
import './ui/styles/layout_sheet.css';
import './ui/styles/layout_phone.css';
import './ui/styles/directors.css';
import './ui/styles/orders.css';
import './ui/styles/queue.css';
import './ui/styles/view.css';
import './ui/styles/readout.css';
import './ui/styles/shapes.css';
import './ui/styles/takes.css';

import { StudioClient } from './link/studio_client';
import { fetchBodies } from './scene/crowd/bodies/gltf_body';
import { StudioApp } from './ui/studio_app';
import { TakeDesk } from './ui/take_desk';
import { StudioView } from './scene/studio_view';

function byId<T extends HTMLElement>(id: string, type: new () => T): T {
  const found = document.getElementById(id);
  if (!(found instanceof type)) throw new Error(`The page has no #${id}.`);
  return found;
}

function socketAddress(): string {
  const url = new URL('ws', document.baseURI);
  url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
  return url.href;
}

const canvas = byId('scene', HTMLCanvasElement);
const view = new StudioView(canvas, byId('overlay', HTMLElement));
const worker = new Worker(new URL('./link/worker.ts', import.meta.url), { type: 'module' });
const client = new StudioClient(worker);
const app = new StudioApp(client, view, canvas, byId('ui', HTMLElement));
new TakeDesk({ client, store: app.store, view, canvas, page: byId('ui', HTMLElement) });
client.connect(socketAddress());
void fetchBodies(document.baseURI, ['body-1', 'body-2']).then((bodies) => view.setBodies(bodies));

/** For the tests in a browser. */
Object.defineProperty(window, '__muster', {
  value: {
    client,
    view,
    get connected() {
      return client.state.phase === 'open';
    },
    get frame() {
      return app.frame;
    },
    get latency() {
      return app.latency.samples;
    },
    get state() {
      return app.store.state;
    },
  },
});
