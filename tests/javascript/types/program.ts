// A user's program, for TypeScript to check: what is right compiles, and each mistake below is found.

import {
  CommandKind,
  FormationKind,
  loadMuster,
  MusterError,
  Status,
  type Characters,
  type Command,
  type CommandInit,
  type GroupDefInit,
  type Muster,
  type Rows,
  type MotionState,
  type Vec2,
  type World,
} from 'muster-engine';
import { Engine, loadStudioModule, webSource, type StudioModule } from 'muster-engine/studio';

const muster: Muster = await loadMuster({
  wasm: new URL('https://example.org/muster.wasm'),
});
const group: GroupDefInit = {
  count: 3,
  formation: { kind: FormationKind.Ring },
  starts: new Float64Array(6),
  colour: null,
};
using world: World = muster.World.create({ groups: [group], seed: 3n });
const characters: Characters = world.characters();
const [x]: Float64Array = characters.position;
const first: number | undefined = x;
const hash: bigint = world.hash();
const touch: CommandInit = {
  kind: CommandKind.Touch,
  body: { touch: 1, position: { x: 1, y: 2 } },
};
world.submit(touch);
const decoded: Command[] = muster.commandDecode(muster.commandEncode(touch));
for (const command of decoded)
  if (command.kind === CommandKind.SetPose) {
    const { position }: { position: Vec2 } = command.body;
    world.submit({ ...command, body: { position } });
  }
const states: Rows<MotionState> = muster.Motion.create(muster.ClipLibrary.own(), true).states();
const column = states.column('position');
const def = muster.Scenario.fromDef({}).def();
def.groups.push({ ...muster.defaultGroupDef(), name: 'more' });
muster.World.create(def);
const took: number = muster.Take.read('/a.take').replay(1, 0, (seen) => seen.stepCount() < 9).steps;
const unpack = (packed: ReadableStream<Uint8Array>): ReadableStream<Uint8Array> => packed;
const { module, loadRest } = await loadStudioModule('https://example.org/engine/', webSource(unpack));
const session: StudioModule = module;
const engine = new Engine(session);
void loadRest();
engine.open('open', 'a test');
try {
  world.step(3);
} catch (error) {
  if (error instanceof MusterError && error.code === Status.NotFound) console.log(error.message);
}
console.log(first, hash, column.length, took);

// @ts-expect-error: no such field
muster.World.create({ groups: [{ cuont: 3 }] });
// @ts-expect-error: not a number
muster.World.create({ groups: [{ count: '3' }] });
// @ts-expect-error: the body of another kind
world.submit({ kind: CommandKind.EditControl, body: { position: { x: 1, y: 2 } } });
// @ts-expect-error: a point needs both numbers
world.submit({ kind: CommandKind.SetPose, body: { position: { x: 1 } } });
// @ts-expect-error: no kind of that number
world.submit({ kind: 99 });
// @ts-expect-error: read-outs are not written
characters.count = 3;
// @ts-expect-error: no such field
states.column('weight');
const taken = muster.Take.read('/a.take');
// @ts-expect-error: a take is no world
muster.Motion.create(muster.ClipLibrary.own()).update(taken);
