// In dark colours obstacles stand out from the ground, also while they are transparent: measured in the picture.
import { expect } from '../support/expect.mjs';

/** The light of what is seen at these spots of the screen, each as the brightest of a column of `tall` px; and of open ground. */
async function lights(studio, spots, tall) {
  const png = (await studio.page.screenshot()).toString('base64');
  return studio.page.evaluate(
    async ([data, list, height]) => {
      const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const pen = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      pen.drawImage(picture, 0, 0);
      const linear = (byte) => (byte <= 10 ? byte / 3294.6 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
      return list.map(({ x, y }) => {
        const { data: bytes } = pen.getImageData(Math.round(x), Math.round(y - height / 2), 1, height);
        const rows = Array.from({ length: height }, (_, i) =>
          [0.2126, 0.7152, 0.0722].reduce((sum, share, k) => sum + share * linear(bytes[4 * i + k]), 0),
        );
        return Math.max(...rows);
      });
    },
    [png, spots, tall],
  );
}

/** Spots on the sides and on the upper edges of an obstacle that the camera sees, and on the ground before them. */
function spotsOf(studio, index) {
  return studio.page.evaluate(async (wanted) => {
    const { camera } = globalThis.__muster.view;
    const { obstacles } = await (await fetch('/scenario')).json();
    const { polygon, height = 3 } = obstacles[wanted];
    const top = Math.min(3.2, height);
    const area = polygon.reduce((sum, [x, y], i) => {
      const [u, v] = polygon[(i + 1) % polygon.length];
      return sum + x * v - u * y;
    }, 0);
    const { eye } = camera.basis();
    const found = { faces: [], edges: [], ground: [] };
    polygon.forEach(([x, y], i) => {
      const [u, v] = polygon[(i + 1) % polygon.length];
      const out = Math.sign(area) / Math.hypot(u - x, v - y);
      const [nx, ny] = [out * (v - y), out * (x - u)];
      if ((eye[0] - x) * nx + (eye[1] - y) * ny <= 0) return;
      for (const t of [0.2, 0.35, 0.5, 0.65, 0.8]) {
        const [a, b] = [x + t * (u - x), y + t * (v - y)];
        found.faces.push(camera.worldToScreen(a, b, 0.5 * top));
        found.edges.push(camera.worldToScreen(a, b, top));
        found.ground.push(camera.worldToScreen(a + 1.5 * nx, b + 1.5 * ny, 0));
      }
    });
    return found;
  }, index);
}

const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
const middle = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

async function standsOut(studio, index, state) {
  const spots = await spotsOf(studio, index);
  const ground = middle(await lights(studio, spots.ground, 1));
  const faces = (await lights(studio, spots.faces, 1)).map((light) => contrast(light, ground));
  const edges = (await lights(studio, spots.edges, 7)).map((light) => contrast(light, ground));
  console.log(`      ${state}: faces ${middle(faces).toFixed(2)}, edges ${middle(edges).toFixed(2)} to the ground`);
  expect(middle(faces) >= 1.6, `the faces of what is ${state} stand out from the ground: ${middle(faces)}`);
  expect(middle(edges) >= 3, `its edge is a clear line: ${middle(edges)}`);
}

export async function darkWalls(studio) {
  const index = await studio.page.evaluate(async () => {
    const { obstacles } = await (await fetch('/scenario')).json();
    return obstacles.findIndex(({ name }) => /granary/i.test(name ?? ''));
  });
  await studio.page.evaluate(() => {
    const { camera } = globalThis.__muster.view;
    const { x, y } = globalThis.__muster.frame.groups[0];
    camera.setPose({ targetX: x + 3, targetY: y, distance: 46, turn: Math.PI / 2, pitch: 0.5 });
  });
  await studio.page.evaluate(() => document.querySelector('#scene').focus({ focusVisible: false }));
  await studio.page.keyboard.press('0');
  await studio.pictures(2);
  await studio.shot('dark-walls');
  await standsOut(studio, index, 'solid');
  await studio.send({ type: 'Commands', commands: [{ kind: 'pose', group: 1, position: [-5.6, 0] }] });
  const thin = (i) => globalThis.__muster.view.solid[i] < 0.35;
  await studio.until('a thin building', thin, index, 30000);
  await studio.wait(400);
  await studio.shot('dark-walls-thin');
  await standsOut(studio, index, 'transparent');
}
