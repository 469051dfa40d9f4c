#include "kiosk/keepsake/souvenir/relief_stl.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "engine/math/portable.h"
#include "kiosk/ground/files/crc32.h"
#include "kiosk/ground/files/zstandard.h"
#include "kiosk/keepsake/souvenir/relief_model.h"

namespace onggi::souvenir {
namespace {

constexpr std::size_t kPlaces = ReliefModel::kFine;
constexpr std::size_t kReliefSums = 8 + 5 * 4, kReliefHead = kReliefSums + 2 * 4;
constexpr std::size_t kMostIndex = 1u << 20;
constexpr std::uint64_t kMostReliefTriangles = 1u << 23;

bool bytes_at(const files::Descriptor& file, std::uint64_t at, std::span<std::byte> into) {
  while (!into.empty()) {
    const ssize_t n = ::pread(file.get(), into.data(), into.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    at += static_cast<std::uint64_t>(n);
    into = into.subspan(static_cast<std::size_t>(n));
  }
  return true;
}

/// Little-endian numbers out of bytes; once they are used up, zeros and short().
class Numbers {
 public:
  explicit Numbers(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint32_t take(std::size_t count) {
    if (bytes_.size() < count) {
      bytes_ = {};
      short_ = true;
      return 0;
    }
    std::uint32_t sum = 0;
    for (std::size_t n = 0; n < count; ++n)
      sum |= std::to_integer<std::uint32_t>(bytes_[n]) << (8 * n);
    bytes_ = bytes_.subspan(count);
    return sum;
  }
  std::string text(std::size_t count) {
    if (bytes_.size() < count) return take(count + 1), std::string();
    std::string out;
    for (const std::byte b : bytes_.first(count)) out += static_cast<char>(b);
    bytes_ = bytes_.subspan(count);
    return out;
  }
  bool is_short() const { return short_; }
  bool all_taken() const { return bytes_.empty() && !short_; }

 private:
  std::span<const std::byte> bytes_;
  bool short_ = false;
};

}  // namespace

ReliefFit fit_of(const files::Descriptor& relief, const files::Descriptor& model) {
  const auto size_of = [](const files::Descriptor& file) {
    struct stat info {};
    return ::fstat(file.get(), &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
  };
  const std::uint64_t size = size_of(relief), pot = size_of(model);
  if (size < kReliefHead || size > kMostRelief) return ReliefFit::damaged;
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  if (!bytes_at(relief, 0, bytes) || std::memcmp(bytes.data(), kReliefMagic, 8) != 0)
    return ReliefFit::damaged;
  const std::span<const std::byte> all(bytes);
  Numbers sums(all.subspan(kReliefSums, 8));
  const std::uint32_t mark = sums.take(4), sum = sums.take(4);
  const auto crc = [](std::span<const std::byte> part, std::uint32_t before) {
    return files::crc32({reinterpret_cast<const std::uint8_t*>(part.data()), part.size()}, before);
  };
  if (crc(all.subspan(kReliefHead), crc(all.first(kReliefHead - 4), 0)) != sum)
    return ReliefFit::damaged;
  std::vector<std::byte> begin(static_cast<std::size_t>(std::min<std::uint64_t>(pot, kMarked)));
  if (!bytes_at(model, 0, begin) || mark_of_model(begin, pot) != mark) return ReliefFit::foreign;
  return ReliefFit::good;
}

int triangles_of_block(bool lower, bool upper) {
  return lower && upper ? 2 * ReliefModel::kFine : lower || upper ? ReliefModel::kFine + 1 : 2;
}

std::optional<ReliefStl> ReliefStl::of(const files::Descriptor& file) {
  std::array<std::byte, kReliefHead> head{};
  struct stat info {};
  if (::fstat(file.get(), &info) != 0 || !bytes_at(file, 0, head) ||
      std::memcmp(head.data(), kReliefMagic, 8) != 0)
    return {};
  Numbers numbers{std::span<const std::byte>(head).subspan(8)};
  ReliefStl stl;
  const std::uint32_t version = numbers.take(4);
  stl.rows_ = numbers.take(4);
  stl.blocks_ = numbers.take(4);
  stl.corners_ = numbers.take(4);
  const std::uint32_t packed = numbers.take(4);
  if (version != kReliefVersion || stl.rows_ < 2 || stl.rows_ > ReliefModel::kMostRows ||
      stl.blocks_ < 2 || stl.blocks_ > ReliefModel::kMostBlocks || stl.corners_ < 3 ||
      stl.corners_ > ReliefModel::kMostCorners || packed > kMostIndex)
    return {};
  std::vector<std::byte> bytes(packed);
  if (!bytes_at(file, kReliefHead, bytes)) return {};
  const auto index = files::unpacked(bytes, kMostIndex);
  if (!index) return {};
  Numbers values(*index);
  stl.title_ = values.text(values.take(4));
  stl.begins_ = {0};
  for (std::size_t n = 0; n < stl.rows_ + 1; ++n)
    stl.begins_.push_back(stl.begins_.back() + values.take(4));
  stl.groups_ = {kReliefHead + packed};
  for (std::size_t from = 0; from < stl.rows_; from += kReliefGroup)
    stl.groups_.push_back(stl.groups_.back() + values.take(4));
  if (!values.all_taken() || stl.triangles() > kMostReliefTriangles ||
      static_cast<std::uint64_t>(info.st_size) != stl.groups_.back())
    return {};
  return stl;
}

std::optional<ReliefStl::Group> ReliefStl::group(const files::Descriptor& file,
                                                 std::size_t number) const {
  std::vector<std::byte> bytes(static_cast<std::size_t>(groups_[number + 1] - groups_[number]));
  if (!bytes_at(file, groups_[number], bytes)) return {};
  const std::size_t most = 4 + blocks_ / 8 + 2 + 8 * corners_ + 2 * kPlaces * blocks_;  // of a row
  const auto unpacked = files::unpacked(bytes, kReliefGroup * most);
  if (!unpacked) return {};
  Numbers values(*unpacked);
  Group out{number, {}};
  std::vector<std::array<std::uint32_t, 2>> before(corners_);
  const std::size_t from = number * kReliefGroup, to = std::min(from + kReliefGroup, rows_);
  for (std::size_t r = from; r < to; ++r) {
    Row row;
    for (double& part : row.faces)
      part = static_cast<std::int16_t>(static_cast<std::uint16_t>(values.take(2))) / 32767.0;
    row.split.resize(blocks_);
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < blocks_; ++b) {
      if (b % 16 == 0) bits = values.take(2);
      row.split[b] = (bits >> b % 16 & 1u) != 0;
    }
    for (std::size_t k = 0; k < 2; ++k)
      for (auto& corner : before) corner[k] += values.take(4);
    row.body = before;
    row.heights.resize(kPlaces * blocks_);
    std::uint16_t last = 0;
    for (std::size_t b = 0; b < blocks_; ++b)
      for (std::size_t k = 0; k < (row.split[b] ? kPlaces : 1); ++k) {
        last = static_cast<std::uint16_t>(last + values.take(2));
        row.heights[b * kPlaces + k] = static_cast<std::int16_t>(last);
      }
    out.rows.push_back(std::move(row));
  }
  if (!values.all_taken()) return {};
  return out;
}

// Metres with y up become millimetres with z up: a quarter turn about x, which keeps the outside
// outside.
ReliefStl::Corner ReliefStl::place(const Row& row, std::size_t at) const {
  const std::size_t places = kPlaces * blocks_;
  at %= places;
  const double corner =
      static_cast<double>(at) * static_cast<double>(corners_) / static_cast<double>(places);
  const auto low = static_cast<std::size_t>(corner);
  const double share = corner - static_cast<double>(low);
  const auto& a = row.body[low % corners_];
  const auto& b = row.body[(low + 1) % corners_];
  const double lift = row.heights[at];
  const double rho =
      std::max(std::lerp(double(a[0]), double(b[0]), share) + lift * row.faces[0], 0.0);
  const double height =
      std::max(std::lerp(double(a[1]), double(b[1]), share) + lift * row.faces[1], 0.0);
  const double angle = 2.0 * portable::kPi * static_cast<double>(at) / static_cast<double>(places);
  // Adding 0 turns -0 into 0, so that equal positions have equal bytes.
  return {static_cast<float>(1e-3 * rho * portable::cos(angle)) + 0.0f,
          static_cast<float>(-1e-3 * rho * portable::sin(angle)) + 0.0f,
          static_cast<float>(1e-3 * height) + 0.0f};
}

ReliefStl::Corner ReliefStl::middle(const Row& row, bool foot) const {
  if (foot) return {0.0f, 0.0f, 0.0f};
  double sum = 0.0, lift = 0.0;
  for (const auto& at : row.body) sum += at[1];
  for (std::size_t b = 0; b < blocks_; ++b) lift += row.heights[b * kPlaces];
  return {0.0f, 0.0f,
          static_cast<float>(1e-3 * (sum / static_cast<double>(corners_) +
                                     row.faces[1] * lift / static_cast<double>(blocks_)))};
}

bool ReliefStl::read(const files::Descriptor& file, std::uint64_t first,
                     std::span<Triangle> into) const {
  const std::uint64_t end = first + into.size();
  if (end > triangles()) return false;
  std::optional<Group> here, there;
  const auto row = [&](std::size_t r) -> const Row* {
    const std::size_t number = r / kReliefGroup;
    std::optional<Group>& kept = number % 2 == 0 ? here : there;
    if (!kept || kept->number != number) kept = group(file, number);
    return kept ? &kept->rows[r % kReliefGroup] : nullptr;
  };
  std::uint64_t at = 0;
  const auto put = [&](const Triangle& triangle) {
    if (at >= first && at < end) into[static_cast<std::size_t>(at - first)] = triangle;
    ++at;
  };
  // Parts: under the foot, the strips, the floor's middle.
  const auto begin = std::upper_bound(begins_.begin(), begins_.end(), first) - begins_.begin() - 1;
  for (auto part = static_cast<std::size_t>(begin); part < rows_ + 1 && begins_[part] < end;
       ++part) {
    at = begins_[part];
    const bool foot = part == 0, floor = part == rows_;
    const Row* lower = row(foot ? 0 : part - 1);
    const Row* upper = foot || floor ? lower : row(part);
    if (lower == nullptr || upper == nullptr) return false;
    for (std::size_t b = 0; b < blocks_; ++b) {
      const bool below = lower->split[b], above = upper->split[b];
      const auto some = foot || floor ? (below ? kPlaces : 1u)
                                      : static_cast<std::size_t>(triangles_of_block(below, above));
      if (at + some <= first || at >= end) {
        at += some;
        continue;
      }
      const auto low = [&](std::size_t k) { return place(*lower, b * kPlaces + k); };
      const auto high = [&](std::size_t k) { return place(*upper, b * kPlaces + k); };
      const std::size_t step = below ? 1 : kPlaces;
      constexpr std::size_t kHalf = kPlaces / 2;
      if (foot || floor) {
        const Corner centre = middle(*lower, foot);
        for (std::size_t k = 0; k < kPlaces; k += step)
          foot ? put({centre, low(k), low(k + step)}) : put({low(k), centre, low(k + step)});
      } else if (below && above) {
        for (std::size_t k = 0; k < kPlaces; ++k) {
          put({low(k), high(k), low(k + 1)});
          put({low(k + 1), high(k), high(k + 1)});
        }
      } else if (below) {
        for (std::size_t k = 0; k < kHalf; ++k) put({low(k), high(0), low(k + 1)});
        put({low(kHalf), high(0), high(kPlaces)});
        for (std::size_t k = kHalf; k < kPlaces; ++k) put({low(k), high(kPlaces), low(k + 1)});
      } else if (above) {
        for (std::size_t k = 0; k < kHalf; ++k) put({low(0), high(k), high(k + 1)});
        put({low(0), high(kHalf), low(kPlaces)});
        for (std::size_t k = kHalf; k < kPlaces; ++k) put({low(kPlaces), high(k), high(k + 1)});
      } else {
        put({low(0), high(0), low(kPlaces)});
        put({low(kPlaces), high(0), high(kPlaces)});
      }
    }
    if (at != begins_[part + 1]) return false;
  }
  return true;
}

}  // namespace onggi::souvenir
