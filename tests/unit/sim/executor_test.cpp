// SPDX-License-Identifier: Apache-2.0
// The seam between a step and threads: what the pool promises, and that another executor may take
// its place.
#include "core/executor.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

#include "avo/error.h"
#include "core/thread_pool.h"
#include "sim/world.h"
#include "support/refusal.h"
#include "unit/sim/scenes.h"

namespace avo {
namespace {

TEST(ThreadPool, does_every_task_once_and_no_two_by_one_worker_at_a_time) {
  constexpr std::size_t kWorkers = 5;
  ThreadPool pool(kWorkers);
  std::vector<std::atomic<int>> busy(kWorkers);
  std::atomic<bool> shared = false, out_of_range = false;
  for (std::size_t round = 0; round < 2000; ++round) {
    std::vector<std::atomic<int>> done(round % 37);
    parallel_for(pool, done.size(), [&](std::size_t index, std::size_t worker) {
      if (worker >= kWorkers) out_of_range = true;
      if (busy[worker % kWorkers].fetch_add(1) != 0) shared = true;
      ++done[index];
      busy[worker % kWorkers].fetch_sub(1);
    });
    for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1) << "round " << round;
  }
  EXPECT_FALSE(shared);
  EXPECT_FALSE(out_of_range);
}

TEST(ThreadPool, helpers_help) {
  ThreadPool pool(3);
  std::atomic<int> meeting = 0;
  // each waits for the others: only three at the same time can end this
  parallel_for(pool, 3, [&](std::size_t, std::size_t) {
    ++meeting;
    while (meeting < 3) std::this_thread::yield();
  });
  EXPECT_EQ(meeting, 3);
}

TEST(ThreadPool, each_worker_begins_with_its_own_share) {
  constexpr std::size_t kWorkers = 3, kTasks = 30, kNone = kTasks;
  for (int round = 0; round < 20; ++round) {
    ThreadPool pool(kWorkers);  // which has had no reason yet to go on without help
    std::vector<std::size_t> first(kWorkers, kNone);  // by worker
    std::atomic<std::size_t> begun = 0;
    parallel_for(pool, kTasks, [&](std::size_t index, std::size_t worker) {
      if (first[worker] != kNone) return;
      first[worker] = index;
      ++begun;
      while (begun < kWorkers) std::this_thread::yield();  // no task finishes before all have begun
    });
    EXPECT_THAT(first, testing::ElementsAre(0, 10, 20));
  }
}

TEST(ThreadPool, throws_what_a_task_threw_and_works_on) {
  ThreadPool pool(3);
  for (int round = 0; round < 200; ++round) {
    EXPECT_THROW(parallel_for(pool, 50,
                              [&](std::size_t index, std::size_t) {
                                if (index % 7 == 3) throw std::runtime_error("task");
                              }),
                 std::runtime_error);
    std::atomic<int> done = 0;
    parallel_for(pool, 50, [&](std::size_t, std::size_t) { ++done; });
    ASSERT_EQ(done, 50);
  }
}

TEST(ThreadPool, ends_without_having_worked) {
  const ThreadPool pool(8);
  EXPECT_EQ(pool.workers(), 8U);
}

#if defined(__linux__)
TEST(ThreadPool, default_threads_are_those_of_the_affinity_mask) {
  cpu_set_t before;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(usable_processors(), static_cast<std::size_t>(CPU_COUNT(&before)));
  cpu_set_t one;
  CPU_ZERO(&one);
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  const int threads = Simulation(test::dense_scene(2, Motion::held)).threads();
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_EQ(threads, 1);
}
#endif

TEST(ThreadPool, the_number_of_threads_is_refused_where_nobody_can_mean_it) {
  const Scenario scene = test::dense_scene(2, Motion::held);
  EXPECT_THROW(Simulation(scene, -1), Error);
  EXPECT_THROW(Simulation(scene, 1025), Error);
  EXPECT_EQ(Simulation(scene, 1024).threads(), 1024);  // none starts for two robots
}

#if defined(__unix__)
// As Python's multiprocessing does.
TEST(ThreadPool, a_child_of_a_fork_goes_on_without_help_and_ends) {
  auto simulation = std::make_unique<Simulation>(test::dense_scene(600, Motion::held), 4);
  simulation->step();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    constexpr unsigned kHang = 1200;  // s
    alarm(kHang);
    simulation->step();
    const std::uint64_t hash = simulation->state_hash();
    simulation.reset();
    _exit(hash == 0 ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  simulation->step();
}
#endif

// A host's job system in miniature: backwards, and each task by another worker.
class Backwards final : public Executor {
 public:
  explicit Backwards(std::size_t workers = 4) : workers_(workers) {}
  [[nodiscard]] std::size_t workers() const override { return workers_; }
  void run(std::size_t count, Task task, void* context) override {
    ++runs;
    EXPECT_GE(count, 2U);
    for (std::size_t k = count; k-- > 0;) task(context, k, (k * 7 + 1) % workers_);
  }
  int runs = 0;

 private:
  std::size_t workers_;
};

TEST(Executor, another_executor_gives_the_same_bits) {
  const Scenario scene = test::dense_scene(300, Motion::held);
  auto backwards = std::make_unique<Backwards>();
  const Backwards& executor = *backwards;
  World world(scene, std::move(backwards));
  World alone(scene, std::make_unique<SerialExecutor>());
  for (int k = 0; k < 60; ++k) {
    step(world);
    step(alone);
  }
  EXPECT_EQ(hash_of(world.fleet, world.movers, world.steps),
            hash_of(alone.fleet, alone.movers, alone.steps));
  EXPECT_GE(executor.runs, 60);
}

TEST(Executor, a_host_steps_simulations_with_its_own) {
  const Scenario scene = test::dense_scene(300, Motion::held);
  const auto host = std::make_shared<Backwards>();
  Simulation simulation(scene, host), alone(scene, 1);
  EXPECT_EQ(simulation.threads(), 4);
  for (int k = 0; k < 20; ++k) simulation.step(), alone.step();
  EXPECT_GE(host->runs, 20);
  EXPECT_EQ(simulation.state_hash(), alone.state_hash());
  Simulation restored(simulation.save(), host);
  const int before = host->runs;
  for (int k = 0; k < 20; ++k) restored.step(), alone.step();
  EXPECT_GE(host->runs, before + 20);
  EXPECT_EQ(restored.state_hash(), alone.state_hash());
}

TEST(Executor, a_host_with_one_worker_does_all_that_is_not_single) {
  const Scenario scene = test::dense_scene(300, Motion::held);
  const auto host = std::make_shared<Backwards>(1);
  Simulation simulation(scene, host), alone(scene, 1);
  for (int k = 0; k < 20; ++k) simulation.step(), alone.step();
  EXPECT_GE(host->runs, 20);
  EXPECT_EQ(simulation.state_hash(), alone.state_hash());
  Simulation small(test::dense_scene(255, Motion::held), host);
  const int before = host->runs;
  small.step();
  EXPECT_EQ(host->runs, before) << "fewer than 256 robots";
}

// Says how many workers it has, and does nothing.
class Idle final : public Executor {
 public:
  explicit Idle(std::size_t workers) : workers_(workers) {}
  [[nodiscard]] std::size_t workers() const override { return workers_; }
  void run(std::size_t, Task, void*) override { throw std::runtime_error("no work today"); }

 private:
  std::size_t workers_;
};

TEST(Executor, a_host_without_workers_is_refused) {
  const Scenario scene = test::dense_scene(300, Motion::held);
  EXPECT_THROW(Simulation(scene, nullptr), Error);
  EXPECT_THROW(Simulation(scene, std::make_shared<Idle>(0)), Error);
  EXPECT_THROW(Simulation(scene, std::make_shared<Idle>(1025)), Error);
}

// Breaks its contract once, in the run of that number and at the task in the midst of it.
class Careless final : public Executor {
 public:
  enum class Fault : unsigned char { none, leaves_out, repeats, wrong_index, wrong_worker, throws };

  [[nodiscard]] std::size_t workers() const override { return 3; }
  void run(std::size_t count, Task task, void* context) override {
    const bool careless = runs++ == careless_run;
    for (std::size_t k = 0; k < count; ++k) {
      const bool wrong = careless && k == count / 2;
      if (wrong && fault == Fault::throws) throw std::runtime_error("no work today");
      if (wrong && fault == Fault::leaves_out) continue;
      task(context, k, wrong && fault == Fault::wrong_worker ? 3 : k % 3);
      if (wrong && fault == Fault::repeats) task(context, k, (k + 1) % 3);
      if (wrong && fault == Fault::wrong_index) task(context, count + k, 0);
    }
  }

  Fault fault = Fault::none;
  int careless_run = -1, runs = 0;
};

// Whatever a host does wrong, no robot has moved, or nothing goes on until a state is restored.
void expect_failed(Simulation& simulation, Careless& host, Careless::Fault fault, int run) {
  SCOPED_TRACE("fault " + std::to_string(static_cast<int>(fault)) + " in run " +
               std::to_string(run));
  const std::vector<std::byte> before = simulation.save();
  const std::uint64_t hash = simulation.state_hash();
  Simulation alone(before, 1);
  alone.step();
  host.fault = fault, host.careless_run = run, host.runs = 0;
  const auto step = [&] { simulation.step(); };
  if (fault == Careless::Fault::throws) {
    EXPECT_THROW(step(), std::runtime_error);
  } else {
    EXPECT_THAT(test::refusal(step), testing::HasSubstr("executor: found "));
  }
  host.fault = Careless::Fault::none;
  bool whole = true;
  try {
    static_cast<void>(simulation.save());
  } catch (const Error&) {
    whole = false;
  }
  if (whole) {
    EXPECT_EQ(simulation.state_hash(), hash);
  } else {
    EXPECT_THROW(simulation.step(), Error);
    simulation.restore(before);
  }
  simulation.step();
  EXPECT_EQ(simulation.state_hash(), alone.state_hash());
}

// 300 robots are stepped in two runs; 1100 are also put in order, which takes many.
TEST(Executor, a_host_that_breaks_its_contract_is_refused) {
  using Fault = Careless::Fault;
  for (const int robots : {300, 1100}) {
    const auto host = std::make_shared<Careless>();
    Simulation simulation(test::dense_scene(robots, Motion::held), host);
    simulation.step();
    while (robots >= 1100 && simulation.steps() < 17) simulation.step();
    const std::vector<std::byte> start = simulation.save();
    simulation.restore(start);
    host->runs = 0;
    simulation.step();
    const int runs = host->runs;
    EXPECT_GE(runs, 2);
    for (const Fault fault : {Fault::leaves_out, Fault::repeats, Fault::wrong_index,
                              Fault::wrong_worker, Fault::throws}) {
      for (int run = 0; run<runs; run += runs> 8 ? 3 : 1) {
        simulation.restore(start);
        expect_failed(simulation, *host, fault, run);
      }
    }
  }
}

// Comes back while its tasks wait, and does them when it is asked again.
class Late final : public Executor {
 public:
  [[nodiscard]] std::size_t workers() const override { return 2; }
  void run(std::size_t count, Task task, void* context) override {
    if (late_) late_();
    late_ = [=] {
      for (std::size_t k = 0; k < count; ++k) task(context, k, 0);
    };
  }
  void work() { late_(); }

 private:
  std::function<void()> late_;
};

TEST(Executor, what_a_host_does_too_late_is_not_done) {
  const auto host = std::make_shared<Late>();
  Simulation simulation(test::dense_scene(300, Motion::held), host);
  const std::uint64_t hash = simulation.state_hash();
  EXPECT_THROW(simulation.step(), Error);
  host->work();
  EXPECT_EQ(simulation.state_hash(), hash);
}

// Calls the second task from within the first one, by a given worker.
class Nested final : public Executor {
 public:
  explicit Nested(std::size_t worker) : worker_(worker) {}
  [[nodiscard]] std::size_t workers() const override { return 2; }
  void run(std::size_t, Task task, void* context) override {
    task_ = task, context_ = context;
    task(context, 0, 0);
  }
  void call_second() { task_(context_, 1, worker_); }

 private:
  std::size_t worker_;
  Task task_ = nullptr;
  void* context_ = nullptr;
};

TEST(Executor, two_tasks_at_the_same_time_have_not_the_same_worker) {
  for (const std::size_t worker : {0U, 1U}) {
    const auto host = std::make_shared<Nested>(worker);
    struct Context {
      Nested& host;
      int done = 0;
    } context{*host};
    const auto run = [&] {
      counted(host)->run(
          2,
          [](void* pointer, std::size_t index, std::size_t) {
            Context& own = *static_cast<Context*>(pointer);
            ++own.done;
            if (index == 0) own.host.call_second();
          },
          &context);
    };
    EXPECT_EQ(test::refusal(run).empty(), worker == 1);
    EXPECT_EQ(context.done, worker == 1 ? 2 : 1);
  }
}

TEST(Executor, what_a_host_throws_ends_the_step) {
  Simulation simulation(test::dense_scene(300, Motion::held), std::make_shared<Idle>(2));
  EXPECT_THROW(simulation.step(), std::runtime_error);
}

}  // namespace
}  // namespace avo
