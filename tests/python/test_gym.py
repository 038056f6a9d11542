"""The environment for learning."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import walkers

import muster
from muster.gym import CrowdEnv


def make(**options) -> CrowdEnv:
    definition = walkers(9, jitter=0.2)
    definition.groups.append(muster.GroupDef(count=4, position=(0.0, 10.0)))
    return CrowdEnv(definition, [(12.0, 0.0), (0.0, 20.0)], **options)


def towards_goals(env: CrowdEnv) -> np.ndarray:
    goals = np.array([(12.0, 0.0), (0.0, 20.0)])
    middles = np.array([env.world.characters.position[g.members].mean(axis=0) for g in env.world.groups])
    return np.hstack([(goals - middles) / 10.0, np.zeros((2, 1))])


def test_orders_to_the_goals_end_the_episode_and_earn_the_distance() -> None:
    env = make(radius=3.0)
    first, info = env.reset(seed=4)
    assert first.shape == env.observation_space.shape == (13, 6) and first.dtype == np.float32
    total, far = 0.0, info["mean_distance"]
    for _ in range(60):
        observation, reward, terminated, truncated, info = env.step(towards_goals(env))
        total += reward
        if terminated or truncated:
            break
    assert terminated and not truncated and info["arrived"] == 1.0
    assert total == pytest.approx(far - info["mean_distance"])
    goals = np.array([(12.0, 0.0), (0.0, 20.0)])[env.world.characters.group]
    assert np.allclose(observation[:, :2], env.world.characters.position - goals, atol=1e-5)


def test_the_same_seed_and_actions_give_the_same_episode() -> None:
    actions = np.random.default_rng(1).uniform(-1, 1, (4, 2, 3))

    def episode(env: CrowdEnv, seed: int) -> tuple[int, float]:
        env.reset(seed=seed)
        rewards = [env.step(action)[1] for action in actions]
        return env.world.hash(), sum(rewards)

    env = make()
    again = episode(env, 7)
    assert episode(env, 7) == again == episode(make(threads=2), 7)
    assert episode(env, 8) != again


def test_time_runs_out_and_bounds_are_kept() -> None:
    env = make(seconds=2.0, decision=0.5)
    env.reset()
    ends = [env.step(np.zeros((2, 3)))[3] for _ in range(4)]
    assert ends == [False, False, False, True]
    assert env.action_space.contains(env.action_space.sample())
    env.step(np.full((2, 3), 1e9))  # Cut to the bounds.
    with pytest.raises(ValueError, match="goals: found 1, expected 2"):
        CrowdEnv(muster.WorldDef(groups=[muster.GroupDef(), muster.GroupDef()]), [(0.0, 0.0)])
    with pytest.raises(RuntimeError, match="expected reset"):
        make().step(np.zeros((2, 3)))
