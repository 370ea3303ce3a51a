// SPDX-License-Identifier: Apache-2.0
// Tables of sweeps that promise more than they have are refused, before memory is taken for it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include "edit_hdf5.h"
#include "sweeps.h"

namespace avo_test {
namespace {

using avo_io::Hdf5Handle;

/// With 128 MiB of memory, and 20 s of a processor, which a busy machine does not shorten.
void expect_no_table(const std::string& table, const std::string& message) {
  const ProcessResult result =
      run_avo({"compare", table}, {.before = [] {
                const rlimit memory{128U << 20U, 128U << 20U}, seconds{20, 20};
                setrlimit(RLIMIT_DATA, &memory);
                setrlimit(RLIMIT_CPU, &seconds);
              }});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, table + message + "\n");
}

constexpr const char* kRefused = ": found no table that avo sweep wrote as HDF5, or a damaged one";

/// Where the column `name` was, one of so many rows of that type and layout.
void put_column(const std::string& h5, const char* name, hsize_t rows, const Hdf5Handle& type,
                const Hdf5Handle& layout) {
  const Hdf5Handle file = open_to_edit(h5),
                   group(H5Gopen2(file.id(), "runs", H5P_DEFAULT), H5Gclose);
  ASSERT_GE(H5Ldelete(group.id(), name, H5P_DEFAULT), 0);
  const Hdf5Handle space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
  const Hdf5Handle column(
      H5Dcreate2(group.id(), name, type.id(), space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT),
      H5Dclose);
  ASSERT_TRUE(column);
}

Hdf5Handle texts_of(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  EXPECT_GE(H5Tset_size(type.id(), size), 0);
  return type;
}

Hdf5Handle layout() {
  return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose};
}

TEST(SweepTables, as_hdf5_that_promise_more_than_their_bytes_are_refused) {
  const hsize_t many = 1'000'000, chunk = 64;
  std::string h5 = swept(kSmallSweep, "runs.h5");
  const Hdf5Handle chunked = layout();
  ASSERT_GE(H5Pset_chunk(chunked.id(), 1, &chunk), 0);
  put_column(h5, "sweep", many, texts_of(4000), chunked);  // these 4 GB are never written
  expect_no_table(h5, kRefused);
  h5 = swept(kSmallSweep, "runs.h5");
  put_column(h5, "sweep", many, texts_of(4000), layout());
  expect_no_table(h5, kRefused);
  h5 = swept(kSmallSweep, "runs.h5");
  put_column(h5, "scene", 24, texts_of(1 << 20), layout());
  expect_no_table(h5, kRefused);
}

TEST(SweepTables, as_hdf5_with_rows_in_other_files_are_refused) {
  const std::string other = swept(kSmallSweep, "other.h5");
  std::string h5 = swept(kSmallSweep, "runs.h5");
  {
    const Hdf5Handle file = open_to_edit(h5);
    ASSERT_GE(H5Ldelete(file.id(), "runs/steps", H5P_DEFAULT), 0);
    ASSERT_GE(H5Lcreate_external(other.c_str(), "runs/steps", file.id(), "runs/steps", H5P_DEFAULT,
                                 H5P_DEFAULT),
              0);
  }
  expect_no_table(h5, kRefused);
  h5 = swept(kSmallSweep, "runs.h5");
  const Hdf5Handle outside = layout(), number(H5Tcopy(H5T_STD_U64LE), H5Tclose);
  write_file(path_of("rows"), std::string(24 * 8, '\1'));
  ASSERT_GE(H5Pset_external(outside.id(), path_of("rows").c_str(), 0, H5F_UNLIMITED), 0);
  put_column(h5, "steps", 24, number, outside);
  expect_no_table(h5, kRefused);
}

TEST(SweepTables, as_csv_of_one_endless_line_are_refused) {
  const std::string csv = path_of("endless.csv");
  write_file(csv, "");
  ASSERT_EQ(truncate(csv.c_str(), off_t{1} << 30U), 0);  // zeros, which take no room on the disk
  expect_no_table(csv, ":1: found more than 1048576 characters, a line must be shorter");
}

TEST(SweepTables, as_csv_of_something_else_are_refused_by_their_first_line) {
  const std::string csv = path_of("other.csv");
  std::string text = "a,b,c,d,e,f\n";
  for (int k = 0; k < 1'000'000; ++k) text += "1,2,3,4,5,6\n";  // in memory 200 MB
  write_file(csv, text);
  expect_no_table(csv,
                  ": found no table of avo sweep, whose first columns must be sweep, run, scene, "
                  "method, parameters, seed, state_hash");
}

}  // namespace
}  // namespace avo_test
