#include "kiosk/keepsake/souvenir/relief_model.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "kiosk/ground/files/byte_writer.h"
#include "kiosk/ground/files/crc32.h"
#include "kiosk/ground/files/zstandard.h"
#include "kiosk/keepsake/souvenir/relief_stl.h"

namespace onggi::souvenir {
namespace {

constexpr double kMicrometres = 1e6;

/// Differences pack well: neighbours are alike. They go round at the ends, and so back.
class Differences {
 public:
  explicit Differences(files::ByteWriter& out) : out_(out) {}
  void whole(std::uint32_t value, std::uint32_t& before) {
    out_.u32(value - before);
    before = value;
  }
  void half(std::uint16_t value, std::uint16_t& before) {
    out_.u16(static_cast<std::uint16_t>(value - before));
    before = value;
  }

 private:
  files::ByteWriter& out_;
};

void put_bits(files::ByteWriter& out, const std::vector<bool>& bits) {
  std::uint16_t word = 0;
  for (std::size_t n = 0; n < bits.size(); ++n) {
    if (bits[n]) word = static_cast<std::uint16_t>(word | 1u << n % 16);
    if (n % 16 == 15 || n + 1 == bits.size()) out.u16(word), word = 0;
  }
}

std::uint32_t sum_of(std::span<const std::byte> bytes, std::uint32_t before) {
  return files::crc32({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, before);
}

std::uint16_t unit_share(float part) {
  return static_cast<std::uint16_t>(
      static_cast<std::int16_t>(std::lround(32767.0f * std::clamp(part, -1.0f, 1.0f))));
}

}  // namespace

std::uint32_t mark_of_model(std::span<const std::byte> begin, std::uint64_t size) {
  const auto sum = sum_of(begin.first(std::min(begin.size(), kMarked)), 0);
  files::ByteWriter out;
  out.u32(static_cast<std::uint32_t>(size));
  out.u32(static_cast<std::uint32_t>(size >> 32));
  return sum_of(out.bytes(), sum);
}

std::vector<std::byte> relief_file(const ReliefModel& model, std::uint32_t pot) {
  const auto count = model.rows.size();
  const auto blocks = static_cast<std::size_t>(model.blocks);
  const std::size_t corners = model.rows.front().body.size();
  // A block of a row has all its places if the strip above it or below it is fine.
  const auto split = [&](std::size_t row, std::size_t block) {
    return (row + 1 < count && model.rows[row].fine[block]) ||
           (row > 0 && model.rows[row - 1].fine[block]);
  };

  std::vector<std::vector<std::byte>> groups;
  std::vector<std::vector<bool>> splits;
  for (std::size_t row = 0; row < count; ++row) {
    std::vector<bool> own(blocks);
    for (std::size_t b = 0; b < blocks; ++b) own[b] = split(row, b);
    splits.push_back(std::move(own));
  }
  for (std::size_t from = 0; from < count; from += kReliefGroup) {
    files::ByteWriter out;
    Differences put(out);
    std::vector<std::array<std::uint32_t, 2>> before(corners);
    for (std::size_t r = from; r < std::min(from + kReliefGroup, count); ++r) {
      const ReliefModel::Row& row = model.rows[r];
      out.u16(unit_share(row.out));
      out.u16(unit_share(row.up));
      put_bits(out, splits[r]);
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t n = 0; n < corners; ++n)
          put.whole(static_cast<std::uint32_t>(std::lround(kMicrometres * double{row.body[n][k]})),
                    before[n][k]);
      std::uint16_t last = 0;
      for (std::size_t b = 0; b < blocks; ++b)
        for (std::size_t k = 0; k < (splits[r][b] ? ReliefModel::kFine : 1u); ++k)
          put.half(static_cast<std::uint16_t>(row.heights[b * ReliefModel::kFine + k]), last);
    }
    groups.push_back(files::packed(out.bytes()));
  }

  files::ByteWriter index;
  index.u32(static_cast<std::uint32_t>(std::min<std::size_t>(model.title.size(), 1000)));
  index.text(std::string_view(model.title).substr(0, 1000));
  const auto edges = [&](std::size_t row) {
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < blocks; ++b) sum += splits[row][b] ? ReliefModel::kFine : 1u;
    return sum;
  };
  index.u32(edges(0));  // triangles under the foot
  for (std::size_t row = 0; row + 1 < count; ++row) {
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < blocks; ++b)
      sum += static_cast<std::uint32_t>(triangles_of_block(splits[row][b], splits[row + 1][b]));
    index.u32(sum);
  }
  index.u32(edges(count - 1));  // and of the floor's middle
  for (const auto& group : groups) index.u32(static_cast<std::uint32_t>(group.size()));
  const auto packed = files::packed(index.bytes());

  files::ByteWriter out;
  out.text(kReliefMagic);
  for (const std::uint32_t value :
       {kReliefVersion, static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(blocks),
        static_cast<std::uint32_t>(corners), static_cast<std::uint32_t>(packed.size()), pot})
    out.u32(value);
  std::uint32_t sum = sum_of(packed, sum_of(out.bytes(), 0));
  for (const auto& group : groups) sum = sum_of(group, sum);
  out.u32(sum);
  out.append(packed);
  for (const auto& group : groups) out.append(group);
  return out.take();
}

}  // namespace onggi::souvenir
