/* SPDX-License-Identifier: Apache-2.0 */
/* Goes on from a saved state: avo_run_saved FILE STEPS THREADS prints the state hash after so many steps. */
#include <avo_c/avo.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

static void require(avo_result result) {
  if (result == AVO_OK) return;
  fprintf(stderr, "%s: %s\n", avo_result_text(result), avo_last_error());
  exit(1);
}

static void* contents(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
    fprintf(stderr, "%s: cannot be read\n", path);
    exit(1);
  }
  *size = (size_t)ftell(file);
  void* bytes = malloc(*size);
  rewind(file);
  if (bytes == NULL || fread(bytes, 1, *size, file) != *size) exit(1);
  fclose(file);
  return bytes;
}

int main(int count, char** arguments) {
  if (count != 4) {
    fprintf(stderr, "usage: avo_run_saved FILE STEPS THREADS\n");
    return 2;
  }
  size_t size = 0;
  void* saved = contents(arguments[1], &size);
  avo_simulation_def def = avo_default_simulation_def();
  def.threads = atoi(arguments[3]);
  avo_simulation_id simulation;
  require(avo_create_simulation_from_saved(saved, size, &def, &simulation));
  for (long step = atol(arguments[2]); step > 0; --step) require(avo_simulation_step(simulation));
  uint64_t hash = 0;
  require(avo_simulation_get_state_hash(simulation, &hash));
  printf("0x%016" PRIx64 "\n", hash);
  free(saved);
  return 0;
}
