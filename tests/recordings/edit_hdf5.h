// SPDX-License-Identifier: Apache-2.0
// Recordings changed behind the back of their writer.
#pragma once
#include <cstdint>
#include <hdf5.h>
#include <string>
#include <vector>

#include "io/recording/hdf5_handle.h"

namespace avo_test {

/// Open for changes; closed at the end of the scope.
avo_io::Hdf5Handle open_to_edit(const std::string& h5);

/// Puts bytes, of that type, in place of the value at the index; of no type: of the table's own.
void change_bytes(const std::string& h5, const char* table, const std::vector<hsize_t>& index,
                  hid_t type, const void* bytes);
template <typename Value>
void change(const std::string& h5, const char* table, const std::vector<hsize_t>& index, hid_t type,
            Value value) {
  change_bytes(h5, table, index, type, &value);
}

/// Without the rows `from` to `to` - 1, as if they had never been recorded.
void leave_out(const std::string& h5, hsize_t from, hsize_t to);

/// How a table lies in the file, with all its rows: as this list of properties says.
void lay_out(const std::string& h5, const char* table, const avo_io::Hdf5Handle& layout);

/// Attributes of the file or, where it is named, of a table. What is there is replaced.
void set_attribute(const std::string& h5, const char* name, std::uint64_t number);
void set_attribute(const std::string& h5, const char* name, const std::string& text,
                   const char* table = nullptr);
void remove_attribute(const std::string& h5, const char* name, const char* table = nullptr);

}  // namespace avo_test
