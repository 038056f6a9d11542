// Commands of every kind, as bytes and back, and as the text of a gestures file.
import { assert, engine, refused, test } from '../checks.mjs';

const { CommandKind } = engine;
const at = (x, y) => ({ x, y });
const box = [at(1, 1), at(3, 1), at(3, 4), at(1, 4)];
const path = {
  waypoints: [
    { time: 1, position: at(0, 0), angle: 0 },
    { time: 4, position: at(5, -2), angle: 0.5 },
  ],
  loop: true,
};
const formation = {
  kind: engine.FormationKind.Outline,
  spacing: 1.25,
  outline: { points: box },
  holes: [{ points: [at(2, 2), at(2, 3), at(2.5, 2)] }],
};
const body = {
  radius: 0.3,
  maxSpeed: 2,
  acceleration: 4,
  mass: 1.5,
  supply: 2,
  unitClass: 3,
  headway: 0.5,
  premovement: 30,
  upstairs: 0.5,
  downstairs: 0.75,
};
const order = {
  kind: engine.OrderKind.Guard,
  manner: engine.Manner.Free,
  turn: engine.Turn.Keep,
  target: at(4, 5),
  facing: 1.25,
  width: 6,
  route: [at(1, 2), at(3, 4)],
  formation,
  pace: 1.5,
  share: 0.75,
  group: 7,
  halfSize: at(2, 1),
  path,
  exits: [4, 2],
  choice: engine.ExitChoice.Nearest,
  attractions: [1.5, -2],
  herding: 3,
  misjudgement: 0.5,
  area: 6,
  seconds: 60,
};
const people = {
  name: 'Gäste',
  share: 0.25,
  unitClass: 2,
  speed: { spread: engine.Spread.Normal, a: 1.25, b: 0.25, least: 0.5, most: 2 },
  premovement: { spread: engine.Spread.Uniform, a: 10, b: 100, least: 0, most: 1e9 },
  upstairs: 0.5,
};
const group = {
  name: 'Grün',
  count: 3,
  formation: {
    kind: engine.FormationKind.Points,
    points: [at(0, 0), at(1, 0), at(2, 0)],
  },
  position: at(3, 4),
  angle: 0.5,
  starts: [at(1, 1), at(2, 2), at(3, 3)],
  jitter: 0.125,
  bodies: [body],
  roles: [{ area: engine.RoleArea.Rim, unitClass: 3 }],
  demands: [1, 2, 3],
  conduct: {
    stance: engine.Stance.Hold,
    cohesion: 0.5,
    squeeze: 0.25,
    avoids: true,
  },
  orders: [order],
  patrols: true,
  colour: 0x12ab34,
  build: engine.BodyBuild.Narrow,
  motions: engine.MotionSet.Weary,
  people: [people],
};
const obstacle = {
  name: 'wall',
  polygon: { points: box },
  path,
  range: 2,
  strength: 3,
  height: 4,
};
const patch = {
  name: 'net',
  polygon: { points: box },
  path,
  motion: 3,
  speed: 0.5,
  ascent: -1.5,
  speedDown: 0.25,
};
const area = {
  name: 'Halt',
  kind: engine.AreaKind.Source,
  polygon: { points: box },
  open: false,
  rate: 1.5,
  group: 2,
  from: 3,
  until: 90,
  most: 40,
  timetable: [{ time: 10, count: 4 }],
};
const checkpoint = {
  position: at(1, 2),
  radius: 3,
  formation,
  once: false,
  trigger: engine.CheckpointTrigger.Mesh,
  share: 0.25,
};

/** A body of each kind, in which every field differs from its default. */
export const kBodies = {
  Touch: { phase: engine.TouchPhase.Down, touch: 3, position: at(1.5, -2.5), time: 0.25, group: 9 },
  AddControl: {
    group: 2,
    kind: engine.ControlKind.Line,
    touches: [5, 6],
    positions: [at(1, 2), at(3, 4)],
    time: 0.75,
  },
  EditControl: { group: 2, control: 8, edit: engine.ControlEdit.Release },
  ReleaseClient: {},
  ChangeGroup: {
    group: 2,
    formation,
    count: 55,
    people: [{ name: 'Slow', share: 2, unitClass: 3 }],
    conduct: group.conduct,
    roles: [{ area: engine.RoleArea.Flanks, unitClass: 2 }],
    demands: [1, 0.5, 2],
    name: 'Vorhut',
    colour: { colour: 0xffee00 },
    look: { build: engine.BodyBuild.Narrow, motions: engine.MotionSet.Weary },
  },
  SetPose: { group: 2, position: at(6, 7), angle: -0.5, characters: true },
  AddGroup: { group },
  RemoveGroup: { group: 3 },
  PutThing: { id: 4, obstacle },
  RemoveThing: { thing: engine.ThingKind.Patch, id: 5 },
  SetParameter: { name: 'plan.exponent', value: 2 },
  GiveOrder: { group: 1, mode: engine.QueueMode.Insert, index: 2, order },
  EditQueue: { group: 1, edit: engine.QueueEdit.Cancel, order: 12 },
  AddCharacters: {
    group: 1,
    positions: [at(1, 2), at(3, 4)],
    bodies: [body, body],
  },
  TransferCharacters: { ids: [4, 5], group: 6 },
  SplitGroup: {
    group: 1,
    by: engine.SplitBy.Lasso,
    points: box,
    abreast: true,
    shape: engine.PartShape.Smaller,
  },
  MergeGroups: { groups: [1, 2, 3], shape: engine.PartShape.Smaller },
  ChangeCharacters: { ids: [7, 8], bodies: [body], driver: engine.Driver.Outside },
  WriteMotion: {
    ids: [7, 8],
    positions: [at(1, 2), at(3, 4)],
    velocities: [at(0.5, 0), at(0, 0.5)],
  },
  ReverseQueue: { group: 2 },
};

/** True where all that was given is found. */
function holds(found, given, where) {
  if (typeof given !== 'object' || given === null) return assert.equal(found, given, where);
  for (const [name, one] of Object.entries(given)) holds(found?.[name], one, `${where}.${name}`);
  if (Array.isArray(given)) assert.equal(found.length, given.length, where);
}

test('commands of every kind become bytes and come back, all that they say', async () => {
  const muster = await engine.loadMuster();
  const kinds = Object.entries(CommandKind).filter(([name]) => name !== 'Count');
  assert.deepEqual(
    Object.keys(kBodies),
    kinds.map(([name]) => name),
  );
  for (const [name, kind] of kinds) {
    const command = {
      kind,
      step: 70000 + kind,
      client: 3,
      sequence: 4000000000,
      body: kBodies[name],
    };
    muster.commandValidate(command);
    const bytes = muster.commandEncode(command);
    const [back, ...others] = muster.commandDecode(bytes);
    assert.equal(others.length, 0);
    holds(back, command, name);
    assert.deepEqual(muster.commandEncode(back), bytes, name);
    assert.equal(muster.commandName(kind), name);
    refused('ParseError', 'command', () => muster.commandDecode(bytes.subarray(0, bytes.length - 1)));
  }
});

test('what a change of a group does not give arrives as null, and an empty list as one', async () => {
  const muster = await engine.loadMuster();
  for (const given of [{ count: 3 }, { roles: [] }, { name: '' }, { people: [], demands: [0.5] }, { colour: {} }]) {
    const command = { kind: CommandKind.ChangeGroup, step: 7, client: 3, sequence: 1, body: { group: 2, ...given } };
    const [back] = muster.commandDecode(muster.commandEncode(command));
    holds(back.body, given, Object.keys(given).join());
    const fields = Object.keys(back.body).filter((name) => back.body[name] !== null);
    assert.deepEqual(fields.sort(), ['group', ...Object.keys(given)].sort());
  }
  const none = { kind: CommandKind.ChangeGroup, step: 7, client: 3, sequence: 1, body: { group: 2 } };
  refused('InvalidArgument', 'ChangeGroup', () => muster.commandValidate(none));
});

test('a thing of every kind arrives as it was put', async () => {
  const muster = await engine.loadMuster();
  const item = { position: at(2, 3), radius: 0.75 };
  for (const put of [{ obstacle }, { id: 6, patch }, { item }, { id: 2, checkpoint, group: 3 }, { area, group: 2 }]) {
    const command = { kind: CommandKind.PutThing, step: 7, client: 3, sequence: 1, body: put };
    const [back] = muster.commandDecode(muster.commandEncode(command));
    holds(back.body, put, Object.keys(put).join());
  }
  const none = { kind: CommandKind.PutThing, step: 7, client: 3, sequence: 1, body: { id: 6 } };
  refused('InvalidArgument', 'PutThing', () => muster.commandValidate(none));
});

test('numbers arrive where the engine looks for them: its own text of the commands says the same', async () => {
  const muster = await engine.loadMuster();
  const commands = ['Touch', 'SetPose', 'ChangeGroup', 'SetParameter', 'GiveOrder', 'WriteMotion'].map((name, k) => ({
    kind: CommandKind[name],
    step: 60 * (k + 1),
    client: 1,
    sequence: k,
    body: kBodies[name],
  }));
  const text = muster.gesturesText(commands, 1 / 60);
  const said = JSON.stringify(JSON.parse(text));
  for (const word of [
    '"x":1.5,"y":-2.5',
    '"plan.exponent","value":2',
    '"Vorhut"',
    '"count":55',
    '"x":6,"y":7,"angle":-0.5',
    '"facing":1.25',
    '"share":0.75',
    '[[0.5,0],[0,0.5]]',
  ])
    assert.ok(said.includes(word), `${word} is missing in ${said}`);
  const back = muster.gesturesParse(text, 'back.json', 1 / 60);
  assert.deepEqual(
    back.map(({ kind, step }) => [kind, step]),
    commands.map(({ kind, step }) => [kind, step]),
  );
  assert.deepEqual(
    back.map(({ body: one }) => one),
    muster.gesturesParse(muster.gesturesText(back, 1 / 60), 'c', 1 / 60).map(({ body: one }) => one),
  );
});

test('arrays of numbers do for arrays of points and ids', async () => {
  const muster = await engine.loadMuster();
  const plain = { kind: CommandKind.WriteMotion, body: kBodies.WriteMotion };
  const typed = {
    kind: CommandKind.WriteMotion,
    body: {
      ids: new Uint32Array([7, 8]),
      positions: new Float64Array([1, 2, 3, 4]),
      velocities: new Float64Array([0.5, 0, 0, 0.5]),
    },
  };
  assert.deepEqual(muster.commandEncode(typed), muster.commandEncode(plain));
  refused('InvalidArgument', 'command.body.positions.length: found 3', () =>
    muster.commandEncode({
      kind: CommandKind.WriteMotion,
      body: { ids: [1], positions: new Float64Array(3) },
    }),
  );
  refused('InvalidArgument', 'command.body.positions: found a Float32Array', () =>
    muster.commandEncode({
      kind: CommandKind.WriteMotion,
      body: { ids: [1], positions: new Float32Array(2) },
    }),
  );
});
