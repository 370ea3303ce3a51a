// SPDX-License-Identifier: Apache-2.0
#include "io/recording/hdf5_chunks.h"

#include <cstdint>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <optional>

#include "io/recording/hdf5_handle.h"

namespace avo_io {
namespace {

/// The layout of a table's chunks in the file.
struct ChunkLayout {
  std::vector<hsize_t> size;  ///< of a chunk, in each dimension
  std::size_t bytes = 0;      ///< of a chunk that is neither shuffled nor deflated
  int deflate = -1;           ///< index of the filter that deflates, or -1
};

/// Takes the known filters, each once: other filters might change the size of a chunk.
bool take_filters(hid_t properties, ChunkLayout& layout) {
  const int count = H5Pget_nfilters(properties);
  bool shuffles = false;
  for (int k = 0; k < count; ++k) {
    unsigned flags = 0, config = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter = H5Pget_filter2(properties, static_cast<unsigned>(k), &flags,
                                               &values, nullptr, 0, nullptr, &config);
    if (filter == H5Z_FILTER_DEFLATE && layout.deflate < 0) {
      layout.deflate = k;
    } else if (filter == H5Z_FILTER_SHUFFLE && !shuffles) {
      shuffles = true;
    } else {
      return false;
    }
  }
  return count >= 0;
}

std::optional<ChunkLayout> layout_of(hid_t table, hid_t properties, std::size_t rank) {
  ChunkLayout layout;
  layout.size.resize(rank);
  const Hdf5Handle type(H5Dget_type(table), H5Tclose);
  if (!type || H5Pget_chunk(properties, static_cast<int>(rank), layout.size.data()) < 0 ||
      !take_filters(properties, layout))
    return std::nullopt;
  layout.bytes = H5Tget_size(type.id());
  for (const hsize_t size : layout.size) layout.bytes *= size;
  return layout;
}

using Inflater = std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>;

struct ChunkBytes {
  std::vector<std::uint8_t> stored, whole;
};

bool is_chunk_whole(hid_t table, const ChunkLayout& layout, const std::vector<hsize_t>& offset,
                    libdeflate_decompressor* inflater, ChunkBytes& bytes) {
  unsigned left_out = 0;  // a bit for each filter that was not applied to this chunk
  haddr_t address = HADDR_UNDEF;
  hsize_t size = 0;
  if (H5Dget_chunk_info_by_coord(table, offset.data(), &left_out, &address, &size) < 0)
    return false;
  if (address == HADDR_UNDEF) return true;  // never written: HDF5 fills it
  const bool deflated = layout.deflate >= 0 && (left_out >> layout.deflate & 1U) == 0;
  if (!deflated) return size == layout.bytes;
  if (size == 0 || size > 2 * layout.bytes + 64) return false;  // longer than deflate ever needs
  bytes.stored.resize(size), bytes.whole.resize(layout.bytes);
  std::uint32_t filters = 0;
  return H5Dread_chunk(table, H5P_DEFAULT, offset.data(), &filters, bytes.stored.data()) >= 0 &&
         libdeflate_zlib_decompress(inflater, bytes.stored.data(), size, bytes.whole.data(),
                                    layout.bytes, nullptr) == LIBDEFLATE_SUCCESS;
}

/// Advances to the next chunk that holds rows; returns false after the last one.
bool next_chunk(const ChunkLayout& layout, const std::vector<hsize_t>& first,
                const std::vector<hsize_t>& end, std::vector<hsize_t>& chunk) {
  for (std::size_t d = chunk.size(); d-- > 0;) {
    chunk[d] += layout.size[d];
    if (chunk[d] < end[d]) return true;
    chunk[d] = first[d];
  }
  return false;
}

}  // namespace

bool are_chunks_whole(hid_t table, const std::vector<hsize_t>& offset,
                      const std::vector<hsize_t>& count) {
  const Hdf5Handle properties(H5Dget_create_plist(table), H5Pclose);
  if (!properties) return false;
  if (H5Pget_layout(properties.id()) != H5D_CHUNKED) return true;
  const auto layout = layout_of(table, properties.id(), offset.size());
  if (!layout) return false;
  const Inflater inflater(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!inflater) throw std::bad_alloc();
  std::vector<hsize_t> first(offset.size()), end(offset.size());
  for (std::size_t d = 0; d < offset.size(); ++d) {
    first[d] = offset[d] / layout->size[d] * layout->size[d];
    end[d] = offset[d] + count[d];
  }
  ChunkBytes bytes;
  std::vector<hsize_t> chunk = first;
  do {
    if (!is_chunk_whole(table, *layout, chunk, inflater.get(), bytes)) return false;
  } while (next_chunk(*layout, first, end, chunk));
  return true;
}

}  // namespace avo_io
