// SPDX-License-Identifier: Apache-2.0
// A file of messages by time: MCAP (https://mcap.dev/spec), with chunks, index and checksums.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "avo_io/output_file.h"

namespace avo_io {

class McapFile {
 public:
  /// The file is not committed here. Like all other members, it throws FileError.
  explicit McapFile(OutputFile& file);

  /// Adds a schema for Protocol Buffers and returns its number.
  std::uint16_t add_schema(const std::string& name, const std::string& descriptors);
  /// Adds a channel and returns its number. All channels must be added before the first message.
  std::uint16_t add_channel(const std::string& topic, std::uint16_t schema);
  /// Writes a message. `time`: ns, ascending.
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message);
  /// Ends the file; call it once after the last message.
  void finish();

 private:
  struct Span {
    std::uint64_t start = 0, end = 0;  // ns
  };
  struct Channel {
    std::uint64_t messages = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> index = {};  // time, offset in the chunk
  };

  void put(std::string_view bytes);
  void put_record(std::uint8_t opcode, const std::string& content);
  void end_chunk();
  [[nodiscard]] std::string statistics() const;
  void put_summary();

  OutputFile& file_;
  std::uint64_t offset_ = 0;                              // bytes
  std::uint32_t crc_ = 0;                                 // of all bytes written
  std::vector<std::string> schemas_, channels_, chunks_;  // contents of records of the summary
  std::map<std::uint16_t, Channel> of_channel_;
  std::string chunk_;
  Span span_, span_of_chunk_;
  std::uint64_t messages_ = 0, messages_of_chunk_ = 0;
};

}  // namespace avo_io
