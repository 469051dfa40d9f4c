#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kiosk/ground/files/descriptor.h"

namespace onggi::souvenir {

/// Triangles of a block between two rows, by which of them has all its places there: 2 if neither,
/// 9 if one, 16 if both.
int triangles_of_block(bool lower, bool upper);

/// A relief's file beside a pot's model.
enum class ReliefFit {
  good,
  damaged,  ///< A byte is not as relief_file() wrote it, or it has over kMostRelief of them.
  foreign,  ///< It is whole, and of another pot.
};
inline constexpr std::uint64_t kMostRelief = 16u << 20;  ///< Bytes; a jar's are 0.1 MB.
/// Reads all of `relief` and the beginning of `model`. Any thread.
ReliefFit fit_of(const files::Descriptor& relief, const files::Descriptor& model);

/// The triangles of a decorated pot with its relief, made of the file that relief_file() wrote when
/// they are asked for. Millimetres, z up, outside facing outwards; closed: each edge has two
/// triangles. Any span can be read without the rest. Any thread.
class ReliefStl {
 public:
  using Corner = std::array<float, 3>;
  using Triangle = std::array<Corner, 3>;

  /// Reads the index. Nothing if `file` is none, is damaged, or holds more than any pot of ours.
  static std::optional<ReliefStl> of(const files::Descriptor& file);
  const std::string& title() const { return title_; }
  std::uint64_t triangles() const { return begins_.back(); }
  /// The triangles from `first` on, `into.size()` of them, all within triangles(). `file`: the
  /// same. False if it has other bytes by now. Allocates what two rows need; 50 kB.
  bool read(const files::Descriptor& file, std::uint64_t first, std::span<Triangle> into) const;

 private:
  struct Row {
    std::array<double, 2> faces{};                   ///< Out and up.
    std::vector<bool> split;                         ///< By block: it has all its places.
    std::vector<std::array<std::uint32_t, 2>> body;  ///< um
    std::vector<std::int16_t> heights;               ///< um
  };
  /// Rows of a group, unpacked.
  struct Group {
    std::size_t number = 0;
    std::vector<Row> rows;
  };
  ReliefStl() = default;
  std::optional<Group> group(const files::Descriptor& file, std::size_t number) const;
  Corner place(const Row& row, std::size_t at) const;
  Corner middle(const Row& row, bool foot) const;

  std::string title_;
  std::size_t rows_ = 0, blocks_ = 0, corners_ = 0;
  /// Of the triangles: those under the foot, then of each strip, then of the floor's middle; and
  /// the end.
  std::vector<std::uint64_t> begins_;
  std::vector<std::uint64_t> groups_;  ///< Where each begins in the file, and the end.
};

}  // namespace onggi::souvenir
