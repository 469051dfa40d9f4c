#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kiosk/ground/files/descriptor.h"
#include "kiosk/keepsake/souvenir/relief_stl.h"

namespace onggi::souvenir {

/// The STL of a kept pot, made when it is asked for: binary, millimetres, z up, outside facing
/// outwards, as slicers expect. It is made of the pot's GLB, or of a decorated pot's relief. Any
/// span of it can be read without the rest, so that a download needs neither memory nor disk. The
/// same file gives the same bytes. Any thread.
class StlOfPot {
 public:
  /// Reads the head of a GLB as content::write_glb writes it, or of a relief as relief_file()
  /// writes it. Nothing if `file` is none of them, or larger than any pot of ours.
  static std::optional<StlOfPot> of(const files::Descriptor& file);
  /// Of the whole STL.
  std::uint64_t size() const;
  /// The bytes from `from` on, `into.size()` of them, all within size(). `file`: the same file.
  /// False if it has other bytes by now. Allocates what these triangles need.
  bool read(const files::Descriptor& file, std::uint64_t from, std::span<std::byte> into) const;

 private:
  /// Triangles of one material.
  struct Part {
    std::uint64_t at = 0;  ///< Of their first index in the file.
    std::uint64_t triangles = 0;
    std::size_t index_bytes = 4;
  };
  StlOfPot() = default;
  static std::optional<StlOfPot> of_glb(const files::Descriptor& glb);
  void begin(const std::string& title, std::uint64_t triangles);
  bool triangles(const files::Descriptor& glb, const Part& part, std::uint64_t first,
                 std::span<std::byte> into) const;
  bool relief_triangles(const files::Descriptor& file, std::uint64_t first,
                        std::span<std::byte> into) const;

  static constexpr std::size_t kHead = 84;  ///< 80 letters, and how many triangles follow.
  std::array<std::byte, kHead> head_{};
  std::uint64_t positions_ = 0, count_ = 0;  ///< In the file.
  std::vector<Part> parts_;
  std::optional<ReliefStl> relief_;  ///< In place of a GLB.
};

}  // namespace onggi::souvenir
