// The studio's page.

import '@fontsource-variable/inter';
import './ui/styles/font.css';
import './ui/styles/tokens.css';
import './ui/styles/base.css';
import './ui/styles/panels.css';
import './ui/styles/messages.css';
import './ui/styles/layout.css';
import './ui/styles/layout_floating.css';
import './ui/styles/layout_sheet.css';
import './ui/styles/layout_phone.css';
import './ui/styles/directors.css';
import './ui/styles/orders.css';
import './ui/styles/queue.css';
import './ui/styles/view.css';
import './ui/styles/readout.css';
import './ui/styles/shapes.css';

import { ask } from './link/answers';
import { StudioClient } from './link/studio_client';
import { fetchBodies } from './scene/crowd/bodies/gltf_body';
import { openSharedLazily } from './ui/directors/lazy_shared';
import { openBuildLazily } from './ui/build/lazy_build';
import { openMeasuresLazily } from './ui/measures/lazy_measures';
import { openPathsLazily } from './ui/takes/lazy_path';
import { openWordsLazily } from './ui/orders/lazy_words';
import { openSequenceLazily } from './ui/formations/lazy_sequence';
import { openLinksLazily } from './ui/places/lazy_links';
import { openPlacesLazily } from './ui/places/lazy_places';
import { openTakesLazily } from './ui/takes/lazy_takes';
import { StudioApp } from './ui/app/studio_app';
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
const ui = byId('ui', HTMLElement);

/** After the first picture [ms]. */
const kSeenAfter = 500;
const kAbout = document.documentElement.dataset;

/** What the page shows: the server writes it to the first element; the studio where it writes nothing. */
async function start(mode: string | undefined): Promise<object> {
  if (mode === 'study') {
    const module = await import('./ui/study/study_app');
    const study = new module.StudyApp(client, view, canvas, ui);
    return {
      get frame() {
        return study.frame;
      },
      get study() {
        return study.state;
      },
    };
  }
  const app = new StudioApp(client, view, canvas, ui);
  const parts = { client, store: app.store, view, canvas, page: ui };
  app.orders.history.listen(client, canvas);
  openTakesLazily(parts, firstSeen);
  openSharedLazily(parts);
  openLinksLazily(parts);
  openPlacesLazily({ ...parts, files: app.files });
  openBuildLazily({ ...parts, history: app.orders.history, cursor: app.cursor });
  openPathsLazily(parts);
  openMeasuresLazily(parts);
  openWordsLazily({ ...parts, frame: () => app.frame });
  openSequenceLazily({ ...parts, queues: app.orders.queues, frame: () => app.frame });
  const standby = kAbout['standby'];
  if (standby !== undefined)
    void import('./ui/app/standby_controller').then(({ standBy }) => standBy(client, app.store, standby));
  return {
    get frame() {
      return app.frame;
    },
    get latency() {
      return app.latency.samples;
    },
    get state() {
      return app.store.state;
    },
  };
}

/** Until people have walked for a moment before somebody's eyes. */
function seen(): Promise<void> {
  return new Promise((done) => {
    const look = (): void => {
      if (view.stats.shownFrame > 0) setTimeout(done, kSeenAfter);
      else requestAnimationFrame(look);
    };
    look();
  });
}

/** Where the page has an engine beside it, its folder stands in the first element: no server is asked. */
async function connect(folder: string | undefined): Promise<void> {
  if (folder === undefined) return client.connect(socketAddress());
  const { startEngine } = await import('./link/engine/start_engine');
  startEngine(client, folder, firstSeen);
}

const firstSeen = seen();
const shown = start(kAbout['mode']);
void shown
  .then(() => connect(kAbout['engine']))
  .then(() => fetchBodies(['body-1', 'body-2']))
  .then((bodies) => view.setBodies(bodies));

/** For the tests in a browser. */
const forTests = {
  ask,
  client,
  view,
  get connected() {
    return client.state.phase === 'open';
  },
};
void shown.then((app) => {
  Object.defineProperties(forTests, Object.getOwnPropertyDescriptors(app));
  Object.defineProperty(window, '__muster', { value: forTests });
});
