/* SPDX-License-Identifier: Apache-2.0 */
/* A host steps a simulation with threads of its own: the same bits for any number of them. A host
 * that breaks the contract is told so. */
#include <pthread.h>

#include "check.h"
#include "cpp_runs.h"

enum { MOST_WORKERS = 5, STEPS = 30 };

/* Threads that wait for work, as those of a job system do. */
typedef struct host {
  pthread_mutex_t mutex;
  pthread_cond_t wake, done;
  pthread_t threads[MOST_WORKERS];
  size_t workers, count, next, finished;
  avo_task* task;
  void* task_context;
  bool ends;
  size_t runs, tasks_of[MOST_WORKERS];
} host;

typedef struct seat {
  host* host;
  size_t worker;
} seat;

static void* work(void* pointer) {
  const seat own = *(seat*)pointer;
  host* h = own.host;
  pthread_mutex_lock(&h->mutex);
  while (!h->ends) {
    if (h->next >= h->count) {
      pthread_cond_wait(&h->wake, &h->mutex);
      continue;
    }
    const size_t index = h->next++;
    pthread_mutex_unlock(&h->mutex);
    h->task(h->task_context, index, own.worker);
    pthread_mutex_lock(&h->mutex);
    ++h->tasks_of[own.worker];
    if (++h->finished == h->count) pthread_cond_signal(&h->done);
  }
  pthread_mutex_unlock(&h->mutex);
  return NULL;
}

static void run_tasks(void* run_context, size_t count, avo_task* task, void* task_context) {
  host* h = run_context;
  pthread_mutex_lock(&h->mutex);
  h->task = task;
  h->task_context = task_context;
  h->next = h->finished = 0;
  h->count = count;
  ++h->runs;
  pthread_cond_broadcast(&h->wake);
  while (h->finished < count) pthread_cond_wait(&h->done, &h->mutex);
  h->count = 0;
  pthread_mutex_unlock(&h->mutex);
}

static avo_simulation_id make(avo_run_tasks* run, void* run_context, int32_t workers) {
  avo_scene_id scene;
  avo_simulation_id simulation;
  avo_simulation_def def = avo_default_simulation_def();
  REQUIRE(avo_load_scene("uniform-1000", NULL, 0, &scene));
  REQUIRE(avo_scene_get_def(scene, &def));
  def.run_tasks = run;
  def.run_context = run_context;
  def.workers = workers;
  REQUIRE(avo_create_simulation(&def, &simulation));
  REQUIRE(avo_destroy_scene(scene));
  return simulation;
}

static void check_host(size_t workers, uint64_t expected) {
  host h = {.workers = workers};
  seat seats[MOST_WORKERS];
  size_t tasks = 0, size = 0;
  int32_t threads = 0;
  void* saved;
  avo_simulation_id simulation = make(run_tasks, &h, (int32_t)workers), copy;
  avo_simulation_def def = avo_default_simulation_def();
  pthread_mutex_init(&h.mutex, NULL);
  pthread_cond_init(&h.wake, NULL);
  pthread_cond_init(&h.done, NULL);
  for (size_t k = 0; k < workers; ++k) {
    seats[k].host = &h;
    seats[k].worker = k;
    CHECK(pthread_create(&h.threads[k], NULL, work, &seats[k]) == 0);
  }
  REQUIRE(avo_simulation_get_threads(simulation, &threads));
  CHECK(threads == (int32_t)workers);
  steps_of(simulation, STEPS / 2);
  REQUIRE(avo_simulation_save(simulation, NULL, 0, &size));
  saved = malloc(size);
  REQUIRE(avo_simulation_save(simulation, saved, size, &size));
  steps_of(simulation, STEPS - STEPS / 2);
  CHECK(hash_of(simulation) == expected);
  /* one that goes on from saved bytes has the host's threads as well */
  def.run_tasks = run_tasks;
  def.run_context = &h;
  def.workers = (int32_t)workers;
  REQUIRE(avo_create_simulation_from_saved(saved, size, &def, &copy));
  free(saved);
  h.runs = 0;
  steps_of(copy, STEPS - STEPS / 2);
  CHECK(hash_of(copy) == expected);
  CHECK(h.runs >= STEPS - STEPS / 2);
  pthread_mutex_lock(&h.mutex);
  h.ends = true;
  pthread_cond_broadcast(&h.wake);
  pthread_mutex_unlock(&h.mutex);
  for (size_t k = 0; k < workers; ++k) {
    CHECK(pthread_join(h.threads[k], NULL) == 0);
    tasks += h.tasks_of[k];
  }
  CHECK(tasks > STEPS);
  REQUIRE(avo_destroy_simulation(copy));
  REQUIRE(avo_destroy_simulation(simulation));
}

/* Hosts that are wrong. */
static void skip_one(void* run_context, size_t count, avo_task* task, void* task_context) {
  (void)run_context;
  for (size_t k = 1; k < count; ++k) task(task_context, k, 0);
}
static void do_one_twice(void* run_context, size_t count, avo_task* task, void* task_context) {
  (void)run_context;
  for (size_t k = 0; k < count; ++k) task(task_context, k, 0);
  task(task_context, 0, 0);
}
static void take_a_wrong_worker(void* run_context, size_t count, avo_task* task,
                                void* task_context) {
  (void)run_context;
  for (size_t k = 0; k < count; ++k) task(task_context, k, 2);
}

static void check_wrong_host(avo_run_tasks* run, const char* text) {
  const avo_simulation_id simulation = make(run, NULL, 2);
  REFUSES(avo_simulation_step(simulation), AVO_ERROR_INVALID_ARGUMENT, text);
  REQUIRE(avo_destroy_simulation(simulation));
}

/* One that leaves out a task in one of its runs, and is right before and after. */
typedef struct faulty {
  int runs, fails_at;
} faulty;

static void skip_one_once(void* run_context, size_t count, avo_task* task, void* task_context) {
  faulty* h = run_context;
  for (size_t k = ++h->runs == h->fails_at ? 1 : 0; k < count; ++k) task(task_context, k, 0);
}

/* Whichever run it is: nobody has moved, or every step is refused until a state is restored. */
static void check_recovery(uint64_t expected) {
  int refused = 0, unmoved = 0;
  for (int fails_at = 1; fails_at <= 8; ++fails_at) {
    faulty h = {0, fails_at};
    avo_simulation_id simulation = make(skip_one_once, &h, 2);
    const uint64_t before = hash_of(simulation);
    avo_result result;
    size_t size = 0;
    void* saved;
    int64_t steps = 0;
    REQUIRE(avo_simulation_save(simulation, NULL, 0, &size));
    saved = malloc(size);
    REQUIRE(avo_simulation_save(simulation, saved, size, &size));
    do result = avo_simulation_step(simulation);
    while (result == AVO_OK);
    CHECK(result == AVO_ERROR_INVALID_ARGUMENT && h.runs == fails_at);
    REQUIRE(avo_simulation_get_steps(simulation, &steps));
    if (avo_simulation_step(simulation) == AVO_OK) {
      ++unmoved;
    } else {
      ++refused;
      REFUSES(avo_simulation_step(simulation), AVO_ERROR_INVALID_VALUE, "earlier step");
      REFUSES(avo_simulation_save(simulation, saved, size, &size), AVO_ERROR_INVALID_VALUE,
              "earlier step");
      REQUIRE(avo_simulation_restore(simulation, saved, size));
      CHECK(hash_of(simulation) == before);
      steps = -1;
    }
    steps_of(simulation, STEPS - (int)steps - 1);
    CHECK(hash_of(simulation) == expected);
    free(saved);
    REQUIRE(avo_destroy_simulation(simulation));
  }
  CHECK(refused > 0 && unmoved > 0);
}

int main(void) {
  const uint64_t expected = cpp_scene_hash("uniform-1000", NULL, STEPS);
  avo_simulation_def def = avo_default_simulation_def();
  avo_simulation_id simulation;
  check_host(1, expected);
  check_host(2, expected);
  check_host(MOST_WORKERS, expected);
  check_wrong_host(skip_one, " tasks done when it returned, must do each once");
  check_wrong_host(do_one_twice, "and calls of wrong index or worker");
  check_wrong_host(take_a_wrong_worker, "run_tasks: found 0 of ");
  check_recovery(expected);
  def.run_tasks = run_tasks;
  def.workers = 0;
  REFUSES(avo_create_simulation(&def, &simulation), AVO_ERROR_INVALID_VALUE, "workers: found 0");
  def.workers = 1025;
  CHECK(avo_create_simulation(&def, &simulation) == AVO_ERROR_INVALID_VALUE);
  return 0;
}
