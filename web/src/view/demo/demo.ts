// The view without a server: `npm run dev`, then /demo.html?theme=dark&count=5000&overlay=cost&time=4. Not in the build.

import '@fontsource-variable/inter';
import { StudioView } from '../studio_view';
import { kMarketSquare } from './market_square';
import { madeUpCost, madeUpFrame, madeUpMeshes } from './made_up_crowd';

const query = new URLSearchParams(location.search);
const theme = query.get('theme') === 'dark' ? 'dark' : 'light';
const count = Number(query.get('count') ?? 0);
const stopAt = Number(query.get('time') ?? 2);

document.documentElement.dataset['theme'] = theme;
const canvas = document.getElementById('scene') as HTMLCanvasElement;
const view = new StudioView(canvas, document.getElementById('overlay') as HTMLElement);
view.setTheme(theme);
view.setScene(kMarketSquare);
const wide = innerWidth >= 1100;
view.setPadding(innerWidth < 520 ? { top: 84, right: 12, bottom: 250, left: 12 }
  : { top: 90, right: wide ? 60 : 30, bottom: wide ? 150 : 200, left: wide ? 190 : 30 });
for (const mesh of madeUpMeshes()) view.setGroupMesh(mesh);
if (query.get('overlay') === 'cost') view.setOverlay(madeUpCost());

let frame = 0;
const timer = setInterval(() => {
  ++frame;
  const time = query.has('run') ? stopAt + 0.5 * Math.sin(frame / 20) : Math.min(stopAt, frame / 30);
  const made = madeUpFrame(frame, time, count);
  if (query.has('near') && frame === 20) view.camera.zoomAt({ x: Number(query.get('x') ?? innerWidth / 2), y: Number(query.get('y') ?? innerHeight / 2) }, Number(query.get('near')));
  view.pushFrame(made, performance.now());
  for (const group of made.groups) {
    for (const control of group.controls) {
      for (const point of control.points) {
        const n = point.path.length;
        if (!point.down) continue;
        view.touchMark(point.touch, { x: point.path[n - 2] ?? 0, y: point.path[n - 1] ?? 0 }, group.id - 1);
      }
    }
  }
  if (query.has('run')) return;
  if (query.has('still') && time >= stopAt) clearInterval(timer);
}, 1000 / 30);

canvas.addEventListener('wheel', (event) => view.camera.zoomAt({ x: event.clientX, y: event.clientY }, Math.exp(-event.deltaY / 400)));
canvas.addEventListener('pointermove', (event) => {
  const to = { x: event.clientX, y: event.clientY };
  if (event.buttons === 1) view.camera.pan({ x: to.x - event.movementX, y: to.y - event.movementY }, to);
  if (event.buttons === 2) view.camera.orbit(event.movementX / 200, event.movementY / 300);
});
canvas.addEventListener('contextmenu', (event) => event.preventDefault());
Object.assign(window, { __muster: { view } });
