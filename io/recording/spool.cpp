// SPDX-License-Identifier: Apache-2.0
// The file that a recording grows in during a run.
#include "io/recording/spool.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <libdeflate.h>
#include <limits>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "io/files/descriptors.h"
#include "io/files/regular_file.h"

namespace avo_io {
namespace {

static_assert(std::endian::native == std::endian::little, "spools have the lowest byte first");

constexpr std::string_view kSpoolBegin = "avo spool 1\n";
enum RecordType : std::uint32_t { header_record = 1, block_record = 2, end_record = 3 };

/// The head of each record.
struct RecordHead {
  std::uint32_t type = 0;
  std::uint32_t payload_checksum = 0;
  std::uint64_t length = 0;    // of the payload
  std::uint32_t checksum = 0;  // of the members above
};
constexpr std::size_t kHeadSize = 20;

std::uint32_t checksum_of(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

std::string head_bytes(const RecordHead& head) {
  std::string bytes(kHeadSize, '\0');
  std::memcpy(bytes.data(), &head.type, 4);
  std::memcpy(bytes.data() + 4, &head.payload_checksum, 4);
  std::memcpy(bytes.data() + 8, &head.length, 8);
  const std::uint32_t own = checksum_of({bytes.data(), 16});
  std::memcpy(bytes.data() + 16, &own, 4);
  return bytes;
}

std::optional<RecordHead> head_from(const std::string& bytes) {
  RecordHead head;
  std::memcpy(&head.type, bytes.data(), 4);
  std::memcpy(&head.payload_checksum, bytes.data() + 4, 4);
  std::memcpy(&head.length, bytes.data() + 8, 8);
  std::memcpy(&head.checksum, bytes.data() + 16, 4);
  if (head.checksum != checksum_of({bytes.data(), 16})) return std::nullopt;
  return head;
}

/// Reads the requested number of bytes; returns false at the end of the file.
bool read_bytes(int descriptor, std::uint64_t offset, std::string& bytes, const std::string& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = pread(descriptor, bytes.data() + done, bytes.size() - done,
                              static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw FileError(with_errno(path));
    if (got == 0) return false;
    done += static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

std::string spool_path(const std::string& recording) {
  return recording + ".part";
}

bool is_spool(std::string_view begin) {
  return begin.starts_with(kSpoolBegin);
}

SpoolWriter::SpoolWriter(const std::string& path, const RecordingHeader& header) : path_(path) {
  descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0 && errno == EEXIST)
    throw FileError(
        fmt::format("{0}: found what another run has left or still writes, must be "
                    "recovered (avo recover {0}) or removed first",
                    path));
  if (descriptor_ < 0) throw FileError(with_errno(path));
  try {
    const std::string fields = packed(fields_of(header));
    if (::write(descriptor_, kSpoolBegin.data(), kSpoolBegin.size()) !=
        static_cast<ssize_t>(kSpoolBegin.size()))
      throw FileError(with_errno(path));
    write_record(header_record, fields);
  } catch (...) {
    close(descriptor_);
    unlink(path.c_str());
    throw;
  }
}

// Removes a spool without rows: it is of no use.
SpoolWriter::~SpoolWriter() {
  close(descriptor_);
  if (times_ == 0) unlink(path_.c_str());
}

void SpoolWriter::write_record(std::uint32_t type, std::string_view payload) {
  std::string bytes = head_bytes({type, checksum_of(payload), payload.size()});
  bytes += payload;
  if (write_all(descriptor_, bytes)) return;
  std::string message = with_errno(path_);
  if (times_ > 0)
    message +=
        fmt::format("; it keeps {0} times, which avo reads, and avo recover {1}", times_, path_);
  throw FileError(message);
}

void SpoolWriter::write(const CompressedBlock& block) {
  const auto count = static_cast<std::uint64_t>(block.time.size());
  std::string payload(sizeof count * (1 + block.time.size()), '\0');
  std::memcpy(payload.data(), &count, sizeof count);
  std::memcpy(payload.data() + sizeof count, block.time.data(), sizeof(double) * block.time.size());
  for (const std::string& chunk : block.chunks) {
    const auto length = static_cast<std::uint64_t>(chunk.size());
    char raw[sizeof length];
    std::memcpy(raw, &length, sizeof length);
    payload.append(raw, sizeof length);
    payload += chunk;
  }
  write_record(block_record, payload);
  times_ += static_cast<std::int64_t>(count);
}

void SpoolWriter::write_end(std::uint64_t state_hash) {
  write_record(end_record, packed({{"state_hash", state_hash}}));
}

SpoolReader::SpoolReader(const std::string& path) : path_(path) {
  descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw FileError(with_errno(path));
  try {
    struct stat status = {};
    if (fstat(descriptor_, &status) != 0) throw FileError(with_errno(path));
    size_ = static_cast<std::uint64_t>(status.st_size);
    std::string begin(kSpoolBegin.size(), '\0');
    const bool whole = read_bytes(descriptor_, 0, begin, path) && begin == kSpoolBegin;
    offset_ = kSpoolBegin.size();
    const std::optional<Record> record = whole ? read_record() : std::nullopt;
    const auto fields =
        record && record->type == header_record ? unpacked(record->payload) : std::nullopt;
    if (!fields)
      throw RecordingError(path +
                           ": found no whole header, cut off or damaged, must be a spool of avo");
    try {
      header_ = header_from(*fields);
    } catch (const avo::Error& error) {
      throw RecordingError(path + ": " + error.what());
    }
    shape_ = shape_of(header_);
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

SpoolReader::~SpoolReader() {
  close(descriptor_);
}

std::optional<SpoolReader::Record> SpoolReader::read_record() {
  std::string bytes(kHeadSize, '\0');
  if (size_ - offset_ < kHeadSize || !read_bytes(descriptor_, offset_, bytes, path_))
    return std::nullopt;
  const std::optional<RecordHead> head = head_from(bytes);
  if (!head || head->length > size_ - offset_ - kHeadSize) return std::nullopt;
  Record record{head->type, std::string(head->length, '\0')};
  if (!read_bytes(descriptor_, offset_ + kHeadSize, record.payload, path_) ||
      checksum_of(record.payload) != head->payload_checksum)
    return std::nullopt;
  offset_ += kHeadSize + head->length;
  return record;
}

bool SpoolReader::unpack(std::string_view payload, CompressedBlock& block) const {
  const auto take = [&payload]() -> std::uint64_t {
    std::uint64_t number = std::numeric_limits<std::uint64_t>::max();
    if (payload.size() < sizeof number) return number;
    std::memcpy(&number, payload.data(), sizeof number);
    payload.remove_prefix(sizeof number);
    return number;
  };
  const std::uint64_t count = take();
  if (count == 0 || count > kBlockTimes || payload.size() < count * sizeof(double)) return false;
  block.time.resize(count);
  std::memcpy(block.time.data(), payload.data(), count * sizeof(double));
  payload.remove_prefix(count * sizeof(double));
  block.chunks.resize(shape_.chunks());
  for (std::string& chunk : block.chunks) {
    const std::uint64_t length = take();
    if (length > payload.size()) return false;
    chunk = payload.substr(0, length);
    payload.remove_prefix(length);
  }
  return payload.empty();
}

bool SpoolReader::next(CompressedBlock& block) {
  const std::uint64_t start = offset_;
  const std::optional<Record> record = read_record();
  if (!record) return false;
  if (record->type == block_record && unpack(record->payload, block)) return true;
  if (record->type == end_record) {
    const auto fields = unpacked(record->payload);
    if (fields && fields->size() == 1)
      if (const auto* hash = std::get_if<std::uint64_t>(&fields->front().value)) {
        header_.state_hash = *hash;
        return false;
      }
  }
  offset_ = start;
  return false;
}

}  // namespace avo_io
