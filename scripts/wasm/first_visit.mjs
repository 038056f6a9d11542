// What somebody does in the first minute with the engine for browsers, without a page: so it is seen which of its functions
// are needed at once.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { root } from '../../schema/read.mjs';
import { encode, fromServer } from '../../schema/wire.mjs';

const kFirst = 'fountain';
/** Each step of the page's loop lets so much time pass [s]. */
const kTick = 1 / 60;

/** Asks where orders lead: those in the queues of the first groups, which have small numbers, and a new one. */
function forecasts() {
  const ask = (group, order, asked) => ({ group, order, asked, placed: order > 1, x: 0, y: 0, facing: 0 });
  const asks = [1, 2].flatMap((group) => [1, 2, 3].map((order) => ask(group, order, null)));
  asks.push(ask(1, 0, { target: [3, 2] }));
  return encode('AskForecasts', { number: 1, asks });
}

/** A page's side of a conversation with the module. */
class FirstVisit {
  constructor(module) {
    this.module = module;
    this.time = 0;
  }

  /** Puts text or bytes where the module can read them while `action` runs. */
  with(bytes, action) {
    const data = typeof bytes === 'string' ? Buffer.from(`${bytes}\0`) : bytes;
    const at = this.module._malloc(data.length);
    this.module.HEAPU8.set(data, at);
    const result = action(at, data.length);
    this.module._free(at);
    return result;
  }

  open(scenario) {
    const failed = this.with(scenario, (name) =>
      this.with('', (version) => this.module._muster_open(name, version, 1)),
    );
    if (failed) throw new Error(`the engine could not open ${scenario}`);
    this.client = this.module._muster_connect();
    this.send(encode('Hello', { name: '' }));
    this.send(encode('Attend', { x: 0, y: 0, count: 100 }));
  }

  send(bytes) {
    this.with(bytes, (at, size) => this.module._muster_receive(this.client, at, size));
  }

  ask(target) {
    this.with('GET', (verb) => this.with(target, (path) => this.module._muster_ask(verb, path, 0, 0)));
    this.module._muster_answer_size();
    this.module._muster_answer_type();
    this.module._muster_answer();
  }

  /** Lets time pass [s], and says of every frame that it was drawn. */
  play(seconds) {
    for (let passed = 0; passed < seconds; passed += kTick) {
      this.module._muster_advance(kTick);
      this.time += kTick;
      const count = this.module._muster_collect(this.client);
      for (let k = 0; k < count; ++k) {
        const at = this.module._muster_message(k);
        const bytes = Buffer.from(this.module.HEAPU8.slice(at, at + this.module._muster_message_size(k)));
        if (bytes[0] === fromServer.Frame) this.send(encode('FrameAck', { frame: bytes.readUInt32LE(1) }));
      }
    }
  }

  /** So many fingers side by side move from one place to another [m] and lift. */
  drag(fingers, [fromX, fromY], [toX, toY]) {
    const all = (phase, x, y) => {
      const finger = (touch) => ({ phase, touch, x: x + (touch % 2), y: y + touch, time: this.time, group: 0 });
      this.send(encode('Touches', { events: Array.from({ length: fingers }, (_, k) => finger(k)) }));
    };
    all('Down', fromX, fromY);
    for (let k = 1; k <= 30; ++k) {
      this.play(kTick);
      all('Move', fromX + ((toX - fromX) * k) / 30, fromY + ((toY - fromY) * k) / 30);
    }
    all('Up', toX, toY);
    this.play(1.5);
  }
}

/** Plays the first scenario with touches, by an engine that has just been loaded. */
export function playFirstVisit(module) {
  const folder = join(root, 'scenarios');
  const names = readdirSync(folder, { recursive: true }).filter(
    (name) => name.endsWith('.json') && !name.startsWith('schema'),
  );
  module.FS.mkdirTree('/takes/removed');
  for (const name of names) {
    module.FS.mkdirTree(dirname(`/scenarios/${name}`));
    module.FS.writeFile(`/scenarios/${name}`, readFileSync(join(folder, name)));
  }
  const visit = new FirstVisit(module);
  visit.open(kFirst);
  for (const target of [
    '/takes',
    `/scenario?name=${kFirst}`,
    '/bodies/body-1.glb',
    '/bodies/body-1-far.glb',
    '/invitation.json',
  ])
    visit.ask(target);
  visit.play(1);
  visit.send(forecasts());
  visit.send(encode('Ping', { time: 1 }));
  visit.play(2);
  for (const fingers of [1, 2, 3]) visit.drag(fingers, [-8 + fingers, 0], [2, 3]);
  for (const action of ['Pause', 'SingleStep', 'Play']) visit.send(encode('Playback', { action }));
  visit.play(1);
}
