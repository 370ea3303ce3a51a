// SPDX-License-Identifier: Apache-2.0
// The records of MCAP, by the tables of https://mcap.dev/spec.
#include "io/export/mcap_file.h"

#include <algorithm>
#include <array>
#include <libdeflate.h>
#include <span>

#include "avo/version.h"

namespace avo_io {
namespace {

constexpr std::string_view kMcapMagic = "\x89MCAP0\r\n";
// bytes; a chunk has at most one message more
constexpr std::size_t kChunkSize = std::size_t{1} << 20U;

enum McapRecord : std::uint8_t {
  op_header = 0x01,
  op_footer = 0x02,
  op_schema = 0x03,
  op_channel = 0x04,
  op_message = 0x05,
  op_chunk = 0x06,
  op_message_index = 0x07,
  op_chunk_index = 0x08,
  op_statistics = 0x0B,
  op_summary_offset = 0x0E,
  op_data_end = 0x0F
};

/// Little-endian numbers, and text with its length in front.
class McapFields {
 public:
  template <typename Number>
  McapFields& number(Number value) {
    for (std::size_t k = 0; k < sizeof value; ++k)
      bytes_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * k) & 0xffU);
    return *this;
  }
  McapFields& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    return raw(value);
  }
  McapFields& raw(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string record_of(std::uint8_t opcode, std::string_view content) {
  return McapFields()
      .number(opcode)
      .number(static_cast<std::uint64_t>(content.size()))
      .raw(content)
      .bytes();
}

}  // namespace

McapFile::McapFile(OutputFile& file) : file_(file) {
  put(kMcapMagic);
  put_record(op_header, McapFields().text("").text(std::string("avo ") + avo::kVersion).bytes());
}

void McapFile::put(std::string_view bytes) {
  file_.write(bytes);
  offset_ += bytes.size();
  crc_ = libdeflate_crc32(crc_, bytes.data(), bytes.size());
}

void McapFile::put_record(std::uint8_t opcode, const std::string& content) {
  put(record_of(opcode, content));
}

std::uint16_t McapFile::add_schema(const std::string& name, const std::string& descriptors) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  schemas_.push_back(McapFields().number(id).text(name).text("protobuf").text(descriptors).bytes());
  put_record(op_schema, schemas_.back());
  return id;
}

std::uint16_t McapFile::add_channel(const std::string& topic, std::uint16_t schema) {
  const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
  channels_.push_back(
      McapFields().number(id).number(schema).text(topic).text("protobuf").text("").bytes());
  put_record(op_channel, channels_.back());
  of_channel_.try_emplace(id);
  return id;
}

void McapFile::write(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  Channel& of = of_channel_.at(channel);
  if (messages_++ == 0) span_.start = time;
  if (messages_of_chunk_++ == 0) span_of_chunk_.start = time;
  span_.end = span_of_chunk_.end = time;
  of.index.emplace_back(time, chunk_.size());
  chunk_ += record_of(op_message, McapFields()
                                      .number(channel)
                                      .number(static_cast<std::uint32_t>(of.messages++))
                                      .number(time)
                                      .number(time)
                                      .raw(message)
                                      .bytes());
  if (chunk_.size() >= kChunkSize) end_chunk();
}

void McapFile::end_chunk() {
  if (messages_of_chunk_ == 0) return;
  const std::uint64_t start = offset_, size = chunk_.size();
  put_record(op_chunk, McapFields()
                           .number(span_of_chunk_.start)
                           .number(span_of_chunk_.end)
                           .number(size)
                           .number(libdeflate_crc32(0, chunk_.data(), chunk_.size()))
                           .text("")
                           .number(size)
                           .raw(chunk_)
                           .bytes());
  const std::uint64_t length = offset_ - start, index_start = offset_;
  McapFields index_offsets;
  for (auto& [id, channel] : of_channel_) {
    if (channel.index.empty()) continue;
    index_offsets.number(id).number(offset_);
    McapFields entries;
    for (const auto& [time, offset] : channel.index) entries.number(time).number(offset);
    put_record(op_message_index, McapFields().number(id).text(entries.bytes()).bytes());
    channel.index.clear();
  }
  chunks_.push_back(McapFields()
                        .number(span_of_chunk_.start)
                        .number(span_of_chunk_.end)
                        .number(start)
                        .number(length)
                        .text(index_offsets.bytes())
                        .number(offset_ - index_start)
                        .text("")
                        .number(size)
                        .number(size)
                        .bytes());
  chunk_.clear();
  messages_of_chunk_ = 0;
}

std::string McapFile::statistics() const {
  McapFields counts;
  for (const auto& [id, channel] : of_channel_) counts.number(id).number(channel.messages);
  constexpr std::uint32_t kNone = 0;  // attachments, metadata
  return McapFields()
      .number(messages_)
      .number(static_cast<std::uint16_t>(schemas_.size()))
      .number(static_cast<std::uint32_t>(channels_.size()))
      .number(kNone)
      .number(kNone)
      .number(static_cast<std::uint32_t>(chunks_.size()))
      .number(span_.start)
      .number(span_.end)
      .text(counts.bytes())
      .bytes();
}

void McapFile::put_summary() {
  const std::array<std::string, 1> statistics_record{statistics()};
  const std::array<std::pair<std::uint8_t, std::span<const std::string>>, 4> groups{
      {{op_schema, schemas_},
       {op_channel, channels_},
       {op_statistics, statistics_record},
       {op_chunk_index, chunks_}}};
  const std::uint64_t start = offset_;
  crc_ = 0;
  McapFields offsets;
  for (const auto& [opcode, records] : groups) {
    if (records.empty()) continue;
    const std::uint64_t group = offset_;
    for (const std::string& record : records) put_record(opcode, record);
    offsets.raw(
        record_of(op_summary_offset,
                  McapFields().number(opcode).number(group).number(offset_ - group).bytes()));
  }
  const std::uint64_t offsets_start = offset_;
  put(offsets.bytes());
  // the checksum covers all bytes before it, also in the footer
  constexpr std::uint64_t kFooterSize = 20;
  put(McapFields()
          .number(op_footer)
          .number(kFooterSize)
          .number(start)
          .number(offsets_start)
          .bytes());
  put(McapFields().number(crc_).bytes());
}

void McapFile::finish() {
  end_chunk();
  put_record(op_data_end, McapFields().number(crc_).bytes());
  put_summary();
  put(kMcapMagic);
}

}  // namespace avo_io
