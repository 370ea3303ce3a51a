// SPDX-License-Identifier: Apache-2.0
// A host's own threads.
#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "simulations.h"

namespace avo_c {
namespace {

// The tasks given to a host; it counts them, so that a host that breaks its contract is detected.
struct Batch {
  avo::Executor::Task task;
  void* context;
  std::size_t count, workers;
  std::vector<std::atomic<bool>>& begun;  // by index
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> is_wrong = false;
};

void do_task(void* pointer, std::size_t index, std::size_t worker) {
  Batch& batch = *static_cast<Batch*>(pointer);
  if (index >= batch.count || worker >= batch.workers || batch.begun[index].exchange(true)) {
    batch.is_wrong = true;
    return;
  }
  batch.task(batch.context, index, worker);
  batch.done.fetch_add(1, std::memory_order_release);
}

class Host final : public avo::Executor {
 public:
  Host(avo_run_tasks* run_tasks, void* context, std::size_t workers)
      : run_tasks_(run_tasks), context_(context), workers_(workers) {}

  [[nodiscard]] std::size_t workers() const override { return workers_; }
  void run(std::size_t count, Task task, void* context) override {
    if (begun_.size() < count) begun_ = std::vector<std::atomic<bool>>(count);
    std::fill_n(begun_.begin(), count, false);
    Batch batch{task, context, count, workers_, begun_};
    run_tasks_(context_, count, do_task, &batch);
    const std::size_t done = batch.done.load(std::memory_order_acquire);
    if (done == count && !batch.is_wrong) return;
    fail(AVO_ERROR_INVALID_ARGUMENT,
         "run_tasks: found " + std::to_string(done) + " of " + std::to_string(count) +
             " tasks done when it returned" +
             (batch.is_wrong ? " and calls of wrong index or worker" : "") +
             ", must do each once, with a worker less than " + std::to_string(workers_));
  }

 private:
  avo_run_tasks* run_tasks_;
  void* context_;
  std::size_t workers_;
  std::vector<std::atomic<bool>> begun_;  // grows, and then nothing is allocated
};

std::shared_ptr<avo::Executor> host_of(const avo_simulation_def& def) {
  if (def.workers < 1)
    fail(AVO_ERROR_INVALID_VALUE,
         "workers: found " + std::to_string(def.workers) + ", must be 1 to 1024 with run_tasks");
  return std::make_shared<Host>(def.run_tasks, def.run_context,
                                static_cast<std::size_t>(def.workers));
}

}  // namespace

avo::Simulation make(const avo::Scenario& scenario, const avo_simulation_def& def) {
  if (def.run_tasks == nullptr) return avo::Simulation(scenario, def.threads);
  return {scenario, host_of(def)};
}

avo::Simulation make(std::span<const std::byte> saved, const avo_simulation_def& def) {
  if (def.run_tasks == nullptr) return avo::Simulation(saved, def.threads);
  return {saved, host_of(def)};
}

}  // namespace avo_c
