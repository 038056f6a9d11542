// Clips, poses and the motion of a crowd.
import { assert, engine, refused, smallDef, test } from '../checks.mjs';

const near = (found, expected, most, what) =>
  assert.ok(Math.abs(found - expected) <= most, `${what}: found ${found}, expected ${expected}`);

test('a clip is written as BVH and read back', async () => {
  const muster = await engine.loadMuster();
  const library = muster.ClipLibrary.own();
  const index = library.find('run');
  const clip = library.get()[index];
  assert.equal(clip.name, 'run');
  const { duration, length, speed } = library.clipMeasures(index);
  near(length / duration, speed, 1e-9, 'speed');
  near(clip.poses.length / 87, duration * clip.rate, 0.5, 'poses');
  const bvh = muster.Bvh.parse(library.clipBvh(index), 'run.bvh');
  const file = bvh.get();
  // The file has a joint on the ground below the hips.
  assert.deepEqual(
    file.joints.map(({ name }) => name),
    ['Root', ...muster.skeleton().map(({ name }) => name)],
  );
  assert.equal(file.values.length, file.frames * file.joints.length * 7);
  near(file.rate, clip.rate, 1e-3, 'rate');
  refused('InvalidArgument', 'clip', () => library.clipMeasures(999));
  refused('ParseError', 'x.bvh:1', () => muster.Bvh.parse('no bvh', 'x.bvh'));
});

test('forward kinematics adds up the offsets of the rest pose', async () => {
  const muster = await engine.loadMuster();
  const root = {
    rotation: { x: 0, y: 0, z: 0, w: 1 },
    translation: { x: 10, y: 20, z: 0 },
  };
  const joints = muster.jointTransforms(muster.restPose(), root);
  assert.equal(joints.length, 21 * 7);
  const at = (joint) => [...joints.subarray(joint * 7 + 4, joint * 7 + 7)];
  muster.skeleton().forEach(({ parent, offset, name }, k) => {
    const from = parent < 0 ? [10, 20, 0] : at(parent);
    [offset.x, offset.y, offset.z].forEach((step, axis) => near(at(k)[axis], from[axis] + step, 1e-4, name));
  });
  const pose = muster.restPose();
  assert.deepEqual(muster.blendPoses(pose, muster.ClipLibrary.own().clipSample(0, 0.3), 0), pose);
});

test('a library of clips of one’s own: given as numbers, and as objects', async () => {
  const muster = await engine.loadMuster();
  const own = muster.ClipLibrary.own().get()[1].copy();
  const library = muster.ClipLibrary.create([own]);
  assert.deepEqual(library.get()[0].poses, own.poses);
  const pose = muster.restPose();
  const plain = {
    name: 'stand',
    motion: 'idle',
    rate: 30,
    cyclic: true,
    poses: [pose, pose],
    travel: [0, 0, 0].map(() => ({ x: 0, y: 0, yaw: 0 })),
  };
  assert.equal(muster.ClipLibrary.create([plain]).get()[0].poses.length, 2 * 87);
  refused('InvalidArgument', 'clips[0].poses[1].hips.z: found nothing', () =>
    muster.ClipLibrary.create([{ ...plain, poses: [pose, { ...pose, hips: { x: 0, y: 0 } }] }]),
  );
});

test('a crowd in motion: states, poses, feet, moments', async () => {
  const muster = await engine.loadMuster();
  const world = muster.World.create(smallDef);
  const motion = muster.Motion.create(muster.ClipLibrary.own());
  motion.setNear([1, 2, 3]);
  world.submit({
    kind: engine.CommandKind.GiveOrder,
    body: { group: 1, order: { target: { x: -12, y: 0 } } },
  });
  for (let k = 0; k < 120; k += 1) {
    world.step();
    motion.update(world);
  }
  const states = motion.states();
  assert.equal(states.length, 36);
  const { position } = world.characters();
  assert.deepEqual([...states.column('position')], [...position]);
  [...states].forEach(({ size }, k) => near(size, muster.characterSize(k + 1), 1e-6, 'size'));
  assert.deepEqual([...motion.near()], [0, 1, 2]);
  assert.equal(motion.nearId(2), 3);
  const joints = motion.joints(0);
  near(joints[4], position[0], 1, 'hips of the first');
  const least = Math.min(...Array.from({ length: 21 }, (_, k) => joints[k * 7 + 6]));
  assert.ok(least > -0.05 && least < 0.3, `feet at ${least} m`);
  assert.equal(typeof motion.locked(0, engine.Limb.LeftFoot), 'boolean');
  assert.equal(muster.limbName(engine.Limb.RightKnee), 'right knee');
  const [moment, snapshot, before] = [motion.moment(), world.snapshot(), motion.pose(1)];
  assert.ok(moment.size() > 100);
  const forward = () => {
    for (let k = 0; k < 20; k += 1) {
      world.step();
      motion.update(world);
    }
    return motion.pose(1);
  };
  const after = forward();
  refused('InvalidArgument', 'MotionState: ', () => states.at(0));
  world.rewind(snapshot);
  motion.goBack(moment);
  assert.deepEqual(motion.pose(1), before);
  assert.deepEqual(forward(), after);
});
