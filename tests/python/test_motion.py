"""Clips and poses."""

from __future__ import annotations

import numpy as np
from conftest import walkers

import muster


def test_bodies_stand_on_the_ground_and_follow_their_characters() -> None:
    world = muster.World(walkers(12))
    world.submit(muster.GiveOrder(1, order=muster.Order.move((12.0, 0.0))))
    motion = muster.CrowdMotion()
    motion.update(world)
    clips = set()
    for _ in range(240):
        world.step()
        motion.update(world)
        clips |= {motion.clips[i] for i in motion.states()["clip"]}
    ids, positions, rotations = motion.joints()
    assert np.array_equal(ids, world.characters.id)
    assert positions.shape == (12, 21, 3) and rotations.shape == (12, 21, 4) and len(muster.JOINTS) == 21
    hips, head = muster.JOINTS.index("Hips"), muster.JOINTS.index("Head")
    feet = [muster.JOINTS.index("LeftFoot"), muster.JOINTS.index("RightFoot")]
    assert np.hypot(*(positions[:, hips, :2] - world.characters.position).T).max() < 0.4
    assert np.all(positions[:, feet, 2].min(axis=1) > 0.0) and np.all(positions[:, feet, 2].min(axis=1) < 0.35)
    assert np.all((positions[:, head, 2] > 1.2) & (positions[:, head, 2] < 1.9))
    assert np.allclose(np.linalg.norm(rotations, axis=2), 1.0, atol=1e-3)
    assert any("walk" in clip or "jog" in clip or "run" in clip for clip in clips)


def test_bones_keep_their_lengths() -> None:
    world = muster.World(walkers(3))
    motion = muster.CrowdMotion()
    motion.update(world)
    _, at_rest, _ = motion.joints()
    world.submit(muster.GiveOrder(1, order=muster.Order.go((8.0, 0.0))))
    for _ in range(90):
        world.step()
        motion.update(world)
    _, moving, _ = motion.joints()
    assert muster.JOINT_PARENTS[0] == -1
    for joint, parent in enumerate(muster.JOINT_PARENTS):
        if parent >= 0:
            before = np.linalg.norm(at_rest[:, joint] - at_rest[:, parent], axis=1)
            after = np.linalg.norm(moving[:, joint] - moving[:, parent], axis=1)
            assert np.allclose(before, after, atol=2e-4), muster.JOINTS[joint]
