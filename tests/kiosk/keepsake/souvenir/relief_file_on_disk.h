#pragma once

#include <fcntl.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kiosk/keepsake/souvenir/relief_model.h"
#include "kiosk/keepsake/souvenir/stl.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::souvenir::test {

/// A relief on the disk, and the STL that is made of it.
struct KeptRelief {
  explicit KeptRelief(std::span<const std::byte> bytes) {
    const auto path = scratch.path() / kRelief;
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    file = files::Descriptor(::open(path.c_str(), O_RDONLY));
  }
  /// Empty if it has none.
  std::vector<std::byte> stl() const {
    const auto made = StlOfPot::of(file);
    std::vector<std::byte> bytes(made ? static_cast<std::size_t>(made->size()) : 0);
    if (made && !made->read(file, 0, bytes)) bytes.clear();
    return bytes;
  }
  files::test::ScratchFolder scratch;
  files::Descriptor file;
};

/// The file of a cup of 40 mm whose wall is rough all round, of the pot with this mark.
inline std::vector<std::byte> rough_relief(std::uint32_t pot) {
  ReliefModel model{"rough", 24, {}};
  for (std::size_t n = 0; n < 48; ++n) {
    const bool up = n < 30;
    ReliefModel::Row row{up ? 1.0f : -1.0f, 0.0f, {}, {}, {}};
    row.body.assign(12, {up ? 0.02f : 0.017f, 0.001f * static_cast<float>(up ? n : 60 - n)});
    for (std::size_t k = 0; k < 24u * ReliefModel::kFine; ++k)
      row.heights.push_back(static_cast<std::int16_t>((n * n + 37 * k) % 400));
    row.fine.assign(24, true);
    model.rows.push_back(std::move(row));
  }
  return relief_file(model, pot);
}

using StlCorner = std::array<float, 3>;
using StlFace = std::array<StlCorner, 3>;

/// The triangles of a binary STL.
inline std::vector<StlFace> faces_of(const std::vector<std::byte>& stl) {
  std::vector<StlFace> faces(stl.size() < 84 ? 0 : (stl.size() - 84) / 50);
  for (std::size_t n = 0; n < faces.size(); ++n)
    std::memcpy(&faces[n], stl.data() + 84 + 50 * n + 12, sizeof(StlFace));
  return faces;
}

/// Edges that have not one triangle on each side.
inline int open_edges(const std::vector<StlFace>& faces) {
  std::map<std::pair<StlCorner, StlCorner>, int> edges;
  for (const StlFace& face : faces)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{face[k], face[(k + 1) % 3]}];
  int open = 0;
  for (const auto& [edge, count] : edges) {
    const auto back = edges.find({edge.second, edge.first});
    if (count != 1 || back == edges.end() || back->second != 1) ++open;
  }
  return open;
}

/// Signed volume, mm^3: positive where faces turn outwards.
inline double volume_of(const std::vector<StlFace>& faces) {
  double six = 0;
  for (const auto& [a, b, c] : faces)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      six += double{a[k]} * (double{b[i]} * double{c[j]} - double{b[j]} * double{c[i]});
    }
  return six / 6;
}

}  // namespace onggi::souvenir::test
