# SPDX-License-Identifier: Apache-2.0
"""Worlds for learning: shapes, determinism, safety, episodes."""
import os
import subprocess
import sys

import avo
import avo.env
import numpy as np
import pytest

E, N, K = 3, 12, 4
SCENE = "uniform-12"


def made(**options):
    return avo.env.VectorEnv(SCENE, E, neighbors=K, **options)


def test_shapes_are_those_of_vector_environments():
    env = made()
    observations, infos = env.reset(seed=1)
    assert observations.shape == env.observation_space.shape == (E, N, 6 + 6 * K) and infos == {}
    assert env.single_observation_space.shape == (N, 6 + 6 * K) and observations.dtype == np.float32
    assert env.observation_space.contains(observations) and env.num_envs == E
    actions = env.action_space.sample()
    assert actions.shape == (E, N, 2) and env.action_space.contains(actions)
    observations, rewards, terminated, truncated, infos = env.step(actions)
    assert observations.shape == (E, N, 6 + 6 * K) and infos == {}
    assert [a.shape for a in (rewards, terminated, truncated)] == [(E, N)] * 3
    assert rewards.dtype == np.float64 and terminated.dtype == truncated.dtype == bool


def test_observations_are_what_is_documented():
    env = made()
    seen, _ = env.reset(seed=5)
    for _ in range(30):
        seen = env.step(np.ones((E, N, 2)))[0]
    position, velocity = env.position(), env.velocity()
    scene = avo.Scenario(SCENE)
    for e in range(E):
        for n in range(N):
            assert np.allclose(seen[e, n, :2], env.goal()[e, n] - position[e, n], atol=1e-4)
            assert np.allclose(seen[e, n, 2:4], velocity[e, n], atol=1e-6)
            assert np.allclose(seen[e, n, 4:6], [scene.robots[n].radius, scene.robots[n].max_speed])
            away = np.linalg.norm(position[e] - position[e, n], axis=1)
            near = [j for j in np.argsort(away) if j != n and away[j] <= scene.sensing_radius][:K]
            others = seen[e, n, 6:].reshape(K, 6)
            assert others[:, 5].tolist() == [1.0] * len(near) + [0.0] * (K - len(near))
            assert not np.any(others[len(near):])
            for row, j in zip(others, near):
                assert np.allclose(row[:2], position[e, j] - position[e, n], atol=1e-4)
                assert np.allclose(row[2:4], velocity[e, j] - velocity[e, n], atol=1e-5)
                assert np.isclose(row[4], env.radius()[e, n] + env.radius()[e, j])


def test_the_same_seed_gives_the_same_bits():
    def rollout(seed):
        env, random, all_seen = made(max_steps=20), np.random.default_rng(0), []
        all_seen.append(env.reset(seed=seed)[0])
        for _ in range(50):  # beyond two ends of episodes
            seen, rewards, *_ = env.step(random.uniform(-2, 2, (E, N, 2)))
            all_seen += [seen, rewards]
        return b"".join(array.tobytes() for array in all_seen)
    assert rollout(3) == rollout(3) != rollout(4)


def test_worlds_begin_anew_as_the_mode_says():
    east = np.ones((E, N, 2))
    first = made().reset(seed=2)[0]
    later = made(max_steps=2)  # NextStep
    later.reset(seed=2)
    later.step(east)
    assert later.step(east)[3].all() and later.metadata["autoreset_mode"] == "NextStep"
    begun, rewards, _, truncated, info = later.step(east)
    assert not truncated.any() and not rewards.any() and info == {}
    at_once = made(max_steps=2, autoreset_mode="SameStep")
    assert np.array_equal(at_once.reset(seed=2)[0], first)
    at_once.step(east)
    seen, rewards, _, truncated, info = at_once.step(east)
    assert truncated.all() and info["_final_obs"].all() and rewards.any()
    assert np.array_equal(seen, begun) and info["final_obs"].shape == seen.shape
    assert not np.array_equal(info["final_obs"], seen)
    assert at_once.step(east)[4] == {}
    never = made(max_steps=2, autoreset_mode="Disabled")
    never.reset(seed=2)
    for _ in range(3):
        seen, _, _, truncated, _ = never.step(east)
    assert truncated.all()
    again, _ = never.reset(options={"reset_mask": np.array([False, True, False])})
    assert np.array_equal(again[0], seen[0]) and not np.array_equal(again[1], seen[1])
    assert never.step(east)[3].all(axis=1).tolist() == [True, False, True]


def test_modes_and_masks_are_checked():
    class Mode:  # as gymnasium's member of an enumeration
        value = "SameStep"
    assert made(autoreset_mode=Mode()).metadata["autoreset_mode"] == "SameStep"
    with pytest.raises(avo.Error, match="autoreset_mode: found 'next', must be one of NextStep, SameStep, Disabled"):
        made(autoreset_mode="next")
    with pytest.raises(avo.Error, match=r"reset_mask: found bool \(2,\), must be bool \(3,\)"):
        made().reset(options={"reset_mask": np.ones(2, dtype=bool)})


def test_nobody_need_be_observed():
    assert avo.env.VectorEnv(SCENE, E, neighbors=0).reset(seed=1)[0].shape == (E, N, 6)


def test_worlds_differ_and_a_reset_without_seed_goes_on():
    env = made()
    first = env.reset(seed=3)[0]
    assert not np.array_equal(first[0], first[1])
    assert not np.array_equal(first, env.reset()[0])


def test_each_world_may_have_a_seed_of_its_own():
    def begun(seed):
        env = made(max_steps=3)
        first = env.reset(seed=seed)[0]
        for _ in range(3 + 1):  # to the next episode
            again = env.step(np.zeros((E, N, 2)))[0]
        return first, again
    seeds = list(range(7, 7 + E))
    (first, again), (other, anew) = begun(seeds), begun(np.array([*seeds[:-1], 99]))
    for one, two in (first, other), (again, anew):
        assert one[:-1].tobytes() == two[:-1].tobytes() and one[-1].tobytes() != two[-1].tobytes()
    assert first[0].tobytes() != again[0].tobytes()
    # None goes on, as without seeds
    env, twin = made(), made()
    env.reset(seed=seeds), twin.reset(seed=seeds)
    on, gone = env.reset()[0], twin.reset(seed=[*seeds[:-1], None])[0]
    assert on[-1].tobytes() == gone[-1].tobytes() and on[0].tobytes() != gone[0].tobytes() == first[0].tobytes()


@pytest.mark.filterwarnings("error")
def test_huge_actions_are_shortened_as_others():
    after = []
    for length in 3.0, 1e20, 1e200, 1.7e308:
        env = made()
        env.reset(seed=1)
        after.append(env.step(np.full((E, N, 2), length))[0])
    assert all(np.allclose(seen, after[0], atol=1e-6) for seen in after)
    assert np.abs(env.velocity()).max() > 0.0


def test_environments_have_what_is_looked_for():
    for env in made(), avo.env.ParallelEnv(SCENE):
        assert env.unwrapped is env and env.spec is None and env.render() is None
        assert env.render_mode is None and env.metadata["render_modes"] == ["rgb_array"]


YARD = {"version": 1, "navigation": False, "robots": [{"position": [0, 0], "goal": [9, 0]}],
        "obstacles": [{"polyline": [[5, -2], [5, 2]]}, {"disc": {"center": [-4, 3], "radius": 1}}],
        "moving_obstacles": [{"position": [0, 4], "velocity": [0.5, 0], "acceleration": [0, -0.1], "radius": 0.7},
                             {"position": [-8, -3], "path": [[8, -3]], "max_speed": 1, "max_deviation": 1},
                             {"trajectory": [[0, 0, 7], [2, 2, 7], [9, 2, 3]]}]}


def test_walls_and_moving_obstacles_are_observed():
    env = avo.env.VectorEnv(YARD, neighbors=4, walls=3)
    env.reset(seed=1)
    simulation = avo.Simulation(YARD)
    simulation.set_preferred_velocity(0, (0, 0))
    for _ in range(40):
        seen = env.step(np.zeros((1, 1, 2)))[0][0, 0]
        simulation.step()
    assert seen.shape == (6 + 6 * 4 + 3 * 3,) and env.single_observation_space.shape == (1, 39)
    others = seen[6:30].reshape(4, 6)
    assert others[:, 5].tolist() == [-1, -1, -1, 0]
    places = simulation.moving_obstacle_position() - env.position()[0, 0]
    order = np.argsort(np.linalg.norm(places, axis=1))
    assert np.allclose(others[:3, :2], places[order], atol=1e-5)
    walls = seen[30:].reshape(3, 3)
    assert np.allclose(walls[0], (-3.2, 2.4, 1), atol=1e-5) and np.allclose(walls[1], (5, 0, 1), atol=1e-5)
    assert not walls[2].any()


def test_robots_evade_moving_obstacles():
    crossed = {"version": 1, "navigation": False, "robots": [{"position": [0, 0], "goal": [9, 0]}],
               "moving_obstacles": [{"position": [4.5, -6], "velocity": [0, 1]}]}
    for action, touched in ([2.0, 0.0], False), ([0.0, 0.0], False):
        env = avo.env.VectorEnv(crossed, neighbors=1, max_steps=200)
        env.reset(seed=0)
        gap = min(np.linalg.norm(env.step([[action]])[0][0, 0, 6:8]) - 1.0 for _ in range(60))
        assert (gap < 0.0) == touched
    assert gap > 2.0


def with_reward(reward):
    env = made(reward=reward)
    env.reset(seed=1)
    return env.step(np.ones((E, N, 2)))[1]


def test_rewards_may_be_ones_own():
    seen = []

    def slow(step):
        seen.append(step)
        return -np.linalg.norm(step.velocity, axis=2)

    rewards = with_reward(slow)
    assert np.allclose(rewards, -0.1) and seen[0].actions.shape == (E, N, 2)
    away = seen[0].clearance
    assert np.all(away > 0.0) and np.allclose(with_reward(lambda step: np.zeros((E, N))), 0.0)
    assert np.allclose(with_reward(avo.env.progress), with_reward(None))


CAR = {"model": "car", "car": {"wheelbase": 1.0, "max_curvature": 0.5, "body": {"offset": 0.4, "radius": 0.7}}}
TRUCK = {"car": {"wheelbase": 2.0, "max_curvature": 0.4, "reverse": True}, "footprint": {"length": 3.5, "width": 1.2, "offset": 1.0}}
DRIVE = {"model": "differential_drive", "drive": {"track": 0.4, "offset": 0.2}, "radius": 0.3}
WHEELS = {"version": 1, "duration": 60, "sensing_radius": 40, "robots": [
    {"position": [-8, 0], "goal": [8, 0], "heading": 0.5, **CAR},
    {"position": [8, 0.5], "goal": [-8, 0.5], "heading": 3.1, **TRUCK},
    {"position": [0, -8], "goal": [0, 8], **DRIVE},
    {"position": [0, 8], "goal": [0, -8]}]}


def test_robots_with_wheels_tell_their_headings():
    env = avo.env.VectorEnv(WHEELS, neighbors=2)
    seen, _ = env.reset(seed=1)
    assert seen.shape == (1, 4, 8 + 6 * 2) == (1, *env.single_observation_space.shape)
    np.testing.assert_allclose(seen[0, :, 6:8], [[np.cos(a), np.sin(a)] for a in (0.5, 3.1, 0.0, 0.0)], atol=1e-6)
    np.testing.assert_allclose(seen[0, 0, :2], [16.0, 0.0])
    np.testing.assert_allclose(seen[0, 0, 4], 0.7)
    # others see the disc of the car, 0.4 m ahead of its axle, and those of the truck as one that covers them
    disc = np.array([-8 + 0.4 * np.cos(0.5), 0.4 * np.sin(0.5)])
    first = min(range(2), key=lambda k: np.linalg.norm(seen[0, 3, 8 + 6 * k : 10 + 6 * k]
                                                      - (disc - [0, 8])))
    np.testing.assert_allclose(seen[0, 3, 8 + 6 * first : 10 + 6 * first], disc - [0, 8], rtol=1e-5)


def test_robots_with_wheels_move_as_their_models_do():
    env = avo.env.VectorEnv(WHEELS, neighbors=0)
    env.reset(seed=1)
    for _ in range(30):
        before, heading = env.position()[0], env.heading()[0]
        env.step([[[0.0, 2.0]] * 4])
        moved, turned = env.position()[0] - before, np.abs(env.heading()[0] - heading)
        middle = 0.5 * (env.heading()[0] + heading)
        across = moved[:, 1] * np.cos(middle) - moved[:, 0] * np.sin(middle)
        assert np.all(np.abs(across[:2]) < 0.02 * np.linalg.norm(moved[:2], axis=1) + 1e-9), "cars slide"
        assert turned[0] <= 0.5 * np.linalg.norm(moved[0]) * 1.001 + 1e-9, "the car turns too sharply"
    assert env.velocity()[0, 3, 1] > 1.5, "a holonomic robot obeys at once"


def test_robots_with_wheels_arrive_and_touch_nobody():
    env = avo.env.VectorEnv(WHEELS, neighbors=3)
    seen, _ = env.reset(seed=1)
    arrived, least = np.zeros(4, dtype=bool), np.inf
    rng = np.random.default_rng(1)
    for step in range(600):
        way = seen[:, :, :2] if step > 60 else rng.uniform(-2, 2, (1, 4, 2))
        seen, _, terminated, truncated, _ = env.step(2.0 * way / np.maximum(1.0, np.linalg.norm(way, axis=2))[:, :, None])
        near = seen[0, [0, 2, 3], 8:].reshape(3, 3, 6)  # the covering disc of the truck is left out
        for k in range(3):
            for other in near[k]:
                if other[4] < 2.0:
                    least = min(least, np.hypot(other[0], other[1]) - other[4])
        arrived |= terminated[0]
        if np.all(terminated | truncated):
            break
    assert least > 0.0
    assert arrived.all()


def test_images_show_robots_walls_and_moving_obstacles():
    env = avo.env.VectorEnv(YARD, 2, render_mode="rgb_array")
    env.reset(seed=1)
    first = env.render()
    assert len(first) == 2 and first[0].dtype == np.uint8 and max(first[0].shape) == 480 and first[0].shape[2] == 3
    colors = {tuple(color) for color in first[0].reshape(-1, 3)}
    assert colors == {(255, 255, 255), (51, 51, 51), (153, 153, 153), (0, 114, 178)}
    for _ in range(10):
        env.step(np.ones((2, 1, 2)))
    again = env.render()[1]
    assert again.shape == first[1].shape and not np.array_equal(again, first[1])
    assert avo.env.ParallelEnv(YARD, render_mode="rgb_array").render().shape == again.shape


def test_spaces_are_gymnasiums_own_where_it_is_installed(tmp_path):
    """By a stub: Debian has no Gymnasium. scripts/gymnasium runs its checks and PettingZoo's by hand."""
    (tmp_path / "gymnasium").mkdir()
    (tmp_path / "gymnasium/__init__.py").write_text("")
    (tmp_path / "gymnasium/spaces.py").write_text(
        "class Box:\n    def __init__(self, low, high, shape, dtype):\n"
        "        self.low, self.high, self.shape, self.dtype = low, high, shape, dtype\n")
    code = ("import avo.env, gymnasium.spaces, numpy\n"
            "env, world = avo.env.VectorEnv('uniform-12', 3, neighbors=4, walls=2), avo.env.ParallelEnv('uniform-12')\n"
            "spaces = [env.observation_space, env.single_observation_space, env.action_space, env.single_action_space,\n"
            "          world.observation_space('robot_0'), world.action_space('robot_0')]\n"
            "assert all(type(s) is gymnasium.spaces.Box and s.dtype is numpy.float32 for s in spaces)\n"
            "assert [s.shape for s in spaces] == [(3, 12, 36), (12, 36), (3, 12, 2), (12, 2), (54,), (2,)]\n"
            "assert env.reset(seed=1)[0].shape == (3, 12, 36)\n")
    path = os.pathsep.join([str(tmp_path), os.environ["PYTHONPATH"]])
    run = subprocess.run([sys.executable, "-c", code], env=dict(os.environ, PYTHONPATH=path), capture_output=True, text=True)
    assert run.returncode == 0, run.stderr


def test_robots_do_not_touch_whatever_the_actions_are():
    env, random = made(), np.random.default_rng(2)
    env.reset(seed=2)
    for k in range(150):
        # all to one place, then anywhere
        actions = -3.0 * env.position() if k < 100 else random.uniform(-9, 9, (E, N, 2))
        before = env.velocity()
        env.step(actions)
        away = np.linalg.norm(env.position()[:, :, None] - env.position()[:, None], axis=3)
        touch = env.radius()[:, :, None] + env.radius()[:, None]
        assert np.all((away >= touch - 1e-9) | np.eye(N, dtype=bool))
        assert np.all(np.linalg.norm(env.velocity() - before, axis=2) <= 1.0 * env.time_step + 1e-9)
    assert np.min(away + 100.0 * np.eye(N)) < 5.0, "nobody was in anybody's way"


def test_robots_move_as_those_of_a_simulation():
    overrides = {"method": "avo_paper", "seed": 9}  # remembers nothing
    scene = avo.Scenario(SCENE, overrides)
    simulation, worlds = avo.Simulation(scene, threads=1), avo.Worlds(1, scene)
    for _ in range(60):
        preferred = [simulation.perceive(n).robot.preferred_velocity for n in range(N)]
        simulation.step()
        worlds.step([preferred], [True])
        assert np.allclose(worlds.position()[0], simulation.position(), atol=1e-9)
        assert np.allclose(worlds.velocity()[0], simulation.velocity(), atol=1e-9)


def test_a_reward_that_fails_leaves_a_counted_step():
    failing = []

    def reward(step):
        step.arrives[:] = True  # its own copy
        if failing:
            raise RuntimeError("no reward")
        return np.full((E, N), np.nan if len(seen) == 1 else 0.0)

    seen = []
    env, other = made(reward=reward), made()
    env.reset(seed=1), other.reset(seed=1)
    actions = np.ones((E, N, 2))
    terminated = env.step(actions)[2]
    assert not terminated.any()
    failing.append(1)
    with pytest.raises(RuntimeError):
        env.step(actions)
    failing.clear()
    seen.append(1)
    with pytest.raises(avo.Error, match="reward: found numbers that are not finite"):
        env.step(actions)
    seen.append(1)
    for _ in range(3):
        other.step(actions)
    observations, *rest = env.step(actions)
    wanted, *others = other.step(actions)
    assert np.array_equal(observations, wanted) and np.array_equal(rest[2], others[2])


def test_rewards_are_progress_and_arrival():
    env = avo.env.VectorEnv({"version": 1, "arrival_distance": 0.5, "robots": [
        {"position": [0, 0], "goal": [3, 0]}, {"position": [0, 50], "goal": [9, 50]}]}, 1, neighbors=1, max_steps=120)
    env.reset(seed=0)
    total, ended = np.zeros(2), None
    for k in range(120):
        _, rewards, terminated, truncated, _ = env.step([[[2.0, 0.0], [0.0, 0.0]]])
        total += rewards[0]
        if terminated[0, 0] and ended is None:
            ended, position = k, env.position()[0, 0]
            assert rewards[0, 0] > 1.0 and np.linalg.norm(position - [3, 0]) <= 0.5
            assert total[0] == pytest.approx(1.0 + 3.0 - np.linalg.norm(position - [3, 0]))
        assert truncated[0].tolist() == [False, k == 119]
    assert ended is not None and total[0] == pytest.approx(1.0 + 3.0, abs=0.5) and total[1] == 0.0
    assert np.linalg.norm(env.position()[0, 0] - [3, 0]) < 0.1, "it goes to its goal by itself"
    rewards, terminated, truncated = env.step([[[2.0, 0.0], [2.0, 0.0]]])[1:4]
    assert not terminated.any() and not truncated.any() and not rewards.any()
    assert np.array_equal(env.position()[0], [[0, 0], [0, 50]]), "it has begun anew"


def test_parallel_environments_have_agents():
    env = avo.env.ParallelEnv(SCENE, neighbors=K, max_steps=15)
    observations, infos = env.reset(seed=4)
    assert env.agents == env.possible_agents == [f"robot_{k}" for k in range(N)]
    assert set(observations) == set(infos) == set(env.agents)
    vector = avo.env.VectorEnv(SCENE, 1, neighbors=K, max_steps=15)
    assert np.array_equal(vector.reset(seed=4)[0][0], [observations[a] for a in env.agents])
    for k in range(15):
        actions = {a: env.action_space(a).sample() for a in env.agents}
        acting = list(env.agents)
        observations, rewards, terminations, truncations, infos = env.step(actions)
        for result in (observations, rewards, terminations, truncations, infos):
            assert list(result) == acting
        assert all(observations[a].shape == env.observation_space(a).shape == (6 + 6 * K,) for a in acting)
        assert env.agents == [a for a in acting if not (terminations[a] or truncations[a])]
    assert env.agents == [] and env.num_agents == 0 and env.max_num_agents == N
    with pytest.raises(avo.Error, match="^step: found no agents"):
        env.step({})


def with_wall(**settings):
    return {"version": 1, "robots": [{"position": [0, 0], "goal": [9, 0]}],
            "obstacles": [{"polyline": [[5, -2], [5, 2]]}], **settings}


def one_agent(action):
    env = avo.env.ParallelEnv(with_wall())
    env.reset(seed=1)
    env.step({"robot_0": action})


def test_worlds_leave_the_way_around_walls_to_the_learner():
    for settings in {}, {"navigation": False}, {"right_of_way": "none"}:
        env = avo.env.VectorEnv(with_wall(**settings), neighbors=0)
        env.reset(seed=np.int64(1))
        for _ in range(100):
            env.step([[[2.0, 0.0]]])
        assert 3.0 < env.position()[0, 0, 0] < 5.0 - env.radius()[0, 0], "it does not go around, nor through"


@pytest.mark.parametrize("make, message", [
    (lambda: avo.env.VectorEnv("planes-12"), "robots.0.model: found airplane, must be holonomic, car or differential"),
    (lambda: avo.env.VectorEnv({"version": 1, "robots": [{"position": [0, 0], "goal": [1, 0], "start_time": 1}]}),
     "robots.0.start_time: found one, must be left out"),
    (lambda: avo.env.VectorEnv(SCENE, walls=-1), "walls: found -1, must be a whole number from 0 to 1000"),
    (lambda: avo.env.VectorEnv(SCENE, render_mode="human"), "render_mode: found 'human', must be 'rgb_array' or None"),
    (lambda: with_reward(lambda step: step.distance[0]), f"reward: found shape ({N},), must be ({E}, {N})"),
    (lambda: with_reward(lambda step: "much"), "reward: found an array of <U4, must be real numbers"),
    (lambda: avo.Worlds(1, avo.Scenario(SCENE)).movers(1), "world: found 1, must be 0 to 0"),
    (lambda: avo.env.VectorEnv(with_wall(navigation=True)), "navigation: found true, must be false or left out in"),
    (lambda: avo.env.VectorEnv(with_wall(right_of_way="told")), "right_of_way: found \"told\", must be seen: told was removed"),
    (lambda: avo.env.VectorEnv(SCENE, 0), "num_envs: found 0, must be a whole number from 1 to 1000000"),
    (lambda: avo.env.VectorEnv(SCENE, max_steps=0), "max_steps: found 0, must be a whole number from 1 to"),
    (lambda: avo.env.VectorEnv(SCENE, max_steps=1.5), "max_steps: found 1.5, must be a whole number from 1 to"),
    (lambda: avo.env.VectorEnv(SCENE, neighbors=-1), "neighbors: found -1, must be a whole number from 0 to 1000"),
    (lambda: avo.env.VectorEnv(SCENE, neighbors=1.5), "neighbors: found 1.5, must be a whole number from 0 to 1000"),
    (lambda: avo.env.ParallelEnv(SCENE, neighbors=10**9), "neighbors: found 1000000000, must be a whole number from"),
    (lambda: avo.env.VectorEnv(SCENE, True), "num_envs: found True, must be a whole number from 1 to 1000000"),
    (lambda: avo.Worlds(1, avo.Scenario(SCENE)).nearest(10**9), "k: found 1000000000, must be 0 to 1000"),
    (lambda: made().reset(seed=[1]), f"seed: found 1 of them, must be {E}, one for each world"),
    (lambda: made().reset(seed=[1, -2, 3][:E]), "seed: found -2, must be a whole number >= 0"),
    (lambda: made().step(np.full((E, N, 2), np.inf)), "actions: found a number that is not finite"),
    (lambda: avo.env.VectorEnv(avo.Scenario(SCENE)), "scene: found a Scenario"),
    (lambda: made().step(np.zeros((E, N, 3))), f"actions: found shape ({E}, {N}, 3), must be ({E}, {N}, 2)"),
    (lambda: made().step(np.full((E, N, 2), np.nan)), "actions: found a number that is not finite"),
    (lambda: made().step(np.full((E, N, 2), 1j)), "actions: found an array of complex128, must be real numbers"),
    (lambda: made().step(np.full((E, N, 2), "1")), "actions: found an array of <U1, must be real numbers"),
    (lambda: made().step([[1.0], [1.0, 2.0]]), "actions: found "),
    (lambda: made().reset(seed=-1), "seed: found -1, must be a whole number >= 0"),
    (lambda: made().reset(seed=0.5), "seed: found 0.5, must be a whole number >= 0"),
    (lambda: made().reset(seed="1"), "seed: found '1', must be a whole number >= 0"),
    (lambda: made().action_space.seed(-1), "seed: found -1, must be a whole number >= 0"),
    (lambda: avo.env.ParallelEnv(SCENE).reset(seed=-1), "seed: found -1, must be a whole number >= 0"),
    (lambda: one_agent([1.0, 2.0, 3.0]), "actions of robot_0: found shape (3,), must be (2,)"),
    (lambda: one_agent(["a", "b"]), "actions of robot_0: found an array of <U1, must be real numbers"),
])
def test_wrong_use_is_a_value_error(make, message):
    with pytest.raises(ValueError) as error:
        make()
    assert message in str(error.value)
