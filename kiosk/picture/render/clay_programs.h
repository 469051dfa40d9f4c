#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/clay_skin.h"
#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// The programs of clay.glsl. Those of a decorated pot are compiled when one is first asked for, so
/// that the start does not wait for them.
class ClayPrograms {
 public:
  /// As in clay.glsl.
  struct Which {
    std::size_t part = 0;
    std::size_t skin = 0;    ///< If it is read: kDry or kGlazed.
    bool torn = false;       ///< Nothing where the part cannot tear, or is read.
    bool decorated = false;  ///< Of a section: beads stand out of it.
    bool read = false;       ///< Not for a section.
  };
  static Result<ClayPrograms> create();
  const Program& of(Which which);
  static bool tears(std::size_t part) { return part != 3; }  ///< A floor does not.
  /// For staff, once: why the driver refused a decorated pot's. It is drawn undecorated then.
  std::vector<std::string> remarks() { return std::exchange(remarks_, {}); }

 private:
  static constexpr std::size_t kParts = 5, kSection = 4;
  using Programs = std::array<std::array<Program, kParts>, ClaySkin::kSkins>;

  /// Plain ones, then a decorated pot's.
  std::array<Programs, 2> drawn_, torn_, read_;
  bool refused_ = false;
  std::vector<std::string> remarks_;
};

}  // namespace onggi::render
