// The crowd steered by fingers: each case ends with an assertion on the simulation and a picture.
import { expect, expectBetween } from '../support/expect.mjs';
import { crowd, distance, distortion, extreme, mean, points, shifted, toSegment } from '../support/geometry.mjs';

const kPoint = 0;
const kLine = 1;
const kArea = 2;

const vertices = (frame) => points(frame.groups[0].vertices);
const controls = (frame) => frame.groups[0].controls;

async function fingersOn(studio, world) {
  const places = await studio.screen(world);
  return Object.fromEntries(places.map((place, i) => [i + 1, place]));
}

async function untilControl(studio, kind, count) {
  const test = ([k, n]) =>
    globalThis.__muster.frame.groups[0].controls.some((one) => one.kind === k && one.points.length === n);
  await studio.until(`a control of kind ${kind} with ${count} points`, test, [kind, count]);
}

/** Waits until every control point stands within `reach` of where its finger is. */
async function untilThere(studio, targets, reach = 0.6) {
  const test = ([list, near]) => {
    const held = globalThis.__muster.frame.groups[0].controls.flatMap((one) => one.points);
    return list.every((target) => held.some((p) => Math.hypot(p.x - target.x, p.y - target.y) < near));
  };
  await studio.until('the control points to arrive', test, [targets, reach], 30000);
}

export async function pointDrag(studio) {
  const before = await studio.frame();
  const corner = extreme(vertices(before), 1, 0.3);
  const target = shifted(corner, 4, 2);
  await studio.fingers.down(await fingersOn(studio, [corner]));
  await untilControl(studio, kPoint, 1);
  await studio.fingers.move(await fingersOn(studio, [target]), { ms: 500 });
  await untilThere(studio, [target]);
  await studio.shot('point');
  const held = controls(await studio.frame())[0];
  expect(held.points[0].down, 'the finger is down');
  const after = await studio.frame();
  const moved = Math.min(...vertices(after).map((v) => distance(v, target)));
  expect(moved < 0.6, `a vertex follows the finger: the nearest is ${moved} m away`);
  await studio.fingers.up();
  await studio.send({ type: 'SetSpeed', factor: 4 });
  await studio.until(
    'the crowd to follow',
    (x) => {
      const { frame } = globalThis.__muster;
      return frame.x.reduce((s, v) => s + v, 0) / frame.x.length > x + 1;
    },
    mean(crowd(before)).x,
    30000,
  );
}

export async function lineDrag(studio) {
  const before = await studio.frame();
  const list = vertices(before);
  const ends = [extreme(list, 1, 1), extreme(list, 1, -1)];
  const targets = [shifted(ends[0], 4, 0), shifted(ends[1], 2.5, -2.5)];
  await studio.fingers.down(await fingersOn(studio, ends));
  await untilControl(studio, kLine, 2);
  await studio.fingers.move(await fingersOn(studio, targets), { ms: 600 });
  await untilThere(studio, targets);
  await studio.eventually(async () => {
    const after = await studio.frame();
    const [line] = controls(after);
    expect(line.kind === kLine, `the control is a line: ${line.kind}`);
    const between = points(line.supplementary);
    expect(between.length >= 3, `vertices between the ends are held: ${between.length}`);
    const off = Math.max(...between.map((p) => toSegment(p, line.points[0], line.points[1])));
    expect(off < 0.3, `the edge stays straight: ${off} m`);
    const onMesh = between.map((p) => Math.min(...vertices(after).map((v) => distance(v, p))));
    expect(Math.max(...onMesh) < 1.2, `the mesh follows the line: ${Math.max(...onMesh)} m`);
  });
  await studio.shot('line');
  await studio.fingers.up();
}

export async function areaDrag(studio) {
  const before = await studio.frame();
  const list = vertices(before);
  const middle = mean(list);
  const corners = [shifted(middle, 2.5, 2.5), shifted(middle, 3.5, -2.5), shifted(middle, -2.5, 0)];
  const targets = corners.map((corner) => shifted(corner, 5, 2));
  await studio.fingers.down(await fingersOn(studio, corners));
  await untilControl(studio, kArea, 3);
  const start = controls(await studio.frame())[0].points;
  await studio.fingers.move(await fingersOn(studio, targets), { ms: 600 });
  await untilThere(studio, targets, 1.1);
  await studio.shot('area');
  const after = await studio.frame();
  const [area] = controls(after);
  expect(area.kind === kArea, `the control is an area: ${area.kind}`);
  const change = distortion(start, area.points);
  expect(change < 0.12, `the area keeps its shape: ${change}`);
  const went = distance(mean(vertices(after)), middle);
  expectBetween(went, 3.5, 7, 'the mesh is carried along');
  await studio.fingers.up();
}

export async function lineAndArea(studio) {
  const before = vertices(await studio.frame());
  const middle = mean(before);
  const left = [extreme(before, -1, 1), extreme(before, -1, -1)];
  const right = [shifted(middle, 2, 3), shifted(middle, 2, -3), shifted(middle, 4.5, 0)];
  const fingers = await fingersOn(studio, [...left, ...right]);
  await studio.fingers.down({ 1: fingers[1], 2: fingers[2] });
  await untilControl(studio, kLine, 2);
  await studio.wait(260);
  await studio.fingers.down({ 3: fingers[3], 4: fingers[4], 5: fingers[5] });
  await untilControl(studio, kArea, 3);
  const bent = await fingersOn(studio, [shifted(left[0], 2.5, -1), shifted(left[1], -2.5, -2)]);
  await studio.fingers.move({ 1: bent[1], 2: bent[2] }, { ms: 700 });
  await untilThere(studio, [shifted(left[0], 2.5, -1)], 0.9);
  await studio.eventually(async () => {
    const frame = await studio.frame();
    const kinds = controls(frame)
      .map((one) => one.kind)
      .sort();
    expect(kinds.join() === `${kLine},${kArea}`, `a line and an area at once: ${kinds}`);
    const after = vertices(frame);
    const half = (sign) => before.map((v, i) => i).filter((i) => sign * (before[i].x - middle.x) > 1.5);
    const change = (part) =>
      distortion(
        part.map((i) => before[i]),
        part.map((i) => after[i]),
      );
    const [bends, keeps] = [change(half(-1)), change(half(1))];
    expect(bends > 1.5 * keeps && bends > 0.1, `the left half bends (${bends}), the right keeps its shape (${keeps})`);
  });
  await studio.shot('line-and-area');
  await studio.fingers.up();
}

export async function drawAheadAndLift(studio) {
  const before = await studio.frame();
  const corner = extreme(vertices(before), 1, 0);
  const way = [shifted(corner, 4, 0), shifted(corner, 8, 3), shifted(corner, 11, 3)];
  const stops = await studio.screen(way);
  const start = await fingersOn(studio, [corner]);
  // Slow motion, so that the finger is ahead of the crowd on slow machines too.
  await studio.send({ type: 'SetSpeed', factor: 0.25 });
  await studio.fingers.down(start);
  for (const at of stops) await studio.fingers.move({ 1: at }, { steps: 6, ms: 60 });
  await studio.fingers.up();
  await studio.until('the lifted finger', () =>
    globalThis.__muster.frame.groups[0].controls.some((one) => !one.points[0].down),
  );
  const lifted = controls(await studio.frame())[0].points[0];
  expect(lifted.path.length >= 4, `the path is still ahead: ${lifted.path.length / 2} checkpoints`);
  expect(distance(lifted, way[2]) > 3, 'the crowd is far behind the finger');
  await studio.shot('draw-ahead');
  await studio.send({ type: 'SetSpeed', factor: 2 });
  await studio.until(
    'the end of the path',
    () => globalThis.__muster.frame.groups[0].controls.length === 0,
    null,
    60000,
  );
  const end = extreme(vertices(await studio.frame()), 1, 0);
  expect(distance(end, way[2]) < 2.5, `the mesh went to the end of the path: ${distance(end, way[2])} m off`);
  await studio.until(
    'the crowd',
    (x) => {
      const { frame } = globalThis.__muster;
      return frame.x.reduce((s, v) => s + v, 0) / frame.x.length > x + 7;
    },
    mean(crowd(before)).x,
    40000,
  );
  await studio.send({ type: 'SetSpeed', factor: 1 });
}

export async function formationOnTheWay(studio) {
  const before = await studio.frame();
  const corner = extreme(vertices(before), 1, 0);
  await studio.fingers.down(await fingersOn(studio, [corner]));
  await studio.fingers.move(await fingersOn(studio, [shifted(corner, 3, 1)]), { ms: 400 });
  const version = before.groups[0].meshVersion;
  const button = studio.page.locator('.formation', { hasText: 'Ring' });
  await button.scrollIntoViewIfNeeded();
  const box = await button.boundingBox();
  await studio.fingers.down({ 9: { x: box.x + box.width / 2, y: box.y + box.height / 2 } });
  await studio.fingers.up([9]);
  await studio.until('the new mesh', (v) => globalThis.__muster.frame.groups[0].meshVersion > v, version);
  expect(controls(await studio.frame()).length === 1, 'the control stays through the change');
  await studio.fingers.move(await fingersOn(studio, [shifted(corner, 6, 2)]), { ms: 400 });
  await studio.shot('formation-on-the-way');
  await studio.fingers.up([1]);
  await studio.until(
    'the button',
    () => document.querySelector('.formation[aria-pressed="true"] .label')?.textContent === 'Ring',
  );
  await studio.until(
    'a ring with an empty middle',
    () => {
      const { frame } = globalThis.__muster;
      const place = frame.groups[0].places;
      let x = 0;
      let y = 0;
      for (let i = 0; i < place.length; i += 2) {
        x += (2 * place[i]) / place.length;
        y += (2 * place[i + 1]) / place.length;
      }
      const far = Array.from(frame.x, (px, i) => Math.hypot(px - x, frame.y[i] - y)).sort((a, b) => a - b);
      return far[Math.floor(0.1 * far.length)] > 2.2;
    },
    null,
    45000,
  );
}

export async function pinchOnGround(studio) {
  const { width, height } = studio.page.viewportSize();
  const frame = await studio.frame();
  const empty = await studio.screen([shifted(mean(vertices(frame)), 0, 0)]);
  const side = empty[0].x < width / 2 ? 1 : -1;
  const middle = { x: width / 2 + side * width * 0.22, y: height * 0.56 };
  const zoom = () => studio.page.evaluate(() => globalThis.__muster.view.pixelsPerMetre());
  const before = await zoom();
  await studio.fingers.down({ 1: { x: middle.x - 30, y: middle.y }, 2: { x: middle.x + 30, y: middle.y } });
  await studio.fingers.move(
    { 1: { x: middle.x - 75, y: middle.y - 10 }, 2: { x: middle.x + 75, y: middle.y + 10 } },
    { ms: 400 },
  );
  await studio.cameraAtRest();
  await studio.shot('pinch');
  const after = await zoom();
  expectBetween(after / before, 1.6, 3.5, 'the fingers went 2.5 times as far apart');
  expect(controls(await studio.frame()).length === 0, 'empty ground makes no control');
  await studio.fingers.up();
}

export async function tenFingers(studio) {
  const list = vertices(await studio.frame());
  const middle = mean(list);
  const around = Array.from({ length: 10 }, (_, i) => {
    const angle = (2 * Math.PI * i) / 10;
    return shifted(middle, 3.5 * Math.cos(angle), 3.5 * Math.sin(angle));
  });
  await studio.fingers.down(await fingersOn(studio, around));
  await studio.until('ten held points', () => {
    return globalThis.__muster.frame.groups[0].controls.reduce((sum, one) => sum + one.points.length, 0) === 10;
  });
  await studio.shot('ten-fingers');
  await studio.fingers.up();
  await studio.until('all fingers gone', () =>
    globalThis.__muster.frame.groups[0].controls.every((one) => one.points.every((p) => !p.down)),
  );
}
