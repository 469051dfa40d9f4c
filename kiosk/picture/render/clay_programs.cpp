#include "kiosk/picture/render/clay_programs.h"

#include "kiosk/picture/render/shaders.h"

namespace onggi::render {
namespace {

Result<Program> compiled(const ClayPrograms::Which& of) {
  const std::string which = "#define PART " + std::to_string(of.part) + "\n#define SKIN " +
                            std::to_string(of.skin) + "\n" + (of.torn ? "#define TORN\n" : "") +
                            (of.read ? "#define READ\n" : "") +
                            (of.decorated ? "#define DECORATED\n" : "");
  return Program::create(
      "clay", {which.c_str(), k_common_glsl, k_light_glsl, k_bare_clay_glsl,
               of.decorated ? k_coat_glsl : "", k_clay_glsl, of.torn ? k_torn_glsl : ""});
}

}  // namespace

Result<ClayPrograms> ClayPrograms::create() {
  ClayPrograms out;
  Result<void> fine;
  const auto make = [&](std::array<Programs, 2>& into, const Which& which) {
    if (!fine) return;
    auto made = compiled(which);
    if (made) {
      into[0][which.skin][which.part] = std::move(*made);
    } else {
      fine = tl::unexpected(made.error());
    }
  };
  for (std::size_t skin = 0; skin < ClaySkin::kSkins; ++skin)
    for (std::size_t part = 0; part < kParts; ++part) {
      make(out.drawn_, {.part = part, .skin = skin});
      if (tears(part)) make(out.torn_, {.part = part, .skin = skin, .torn = true});
      if (part != kSection && (skin == ClaySkin::kDry || skin == ClaySkin::kGlazed))
        make(out.read_, {.part = part, .skin = skin, .read = true});
    }
  if (!fine) return tl::unexpected(fine.error());
  return out;
}

const Program& ClayPrograms::of(Which which) {
  which.torn = which.torn && tears(which.part) && !which.read;
  std::array<Programs, 2>& both = which.read ? read_ : which.torn ? torn_ : drawn_;
  const Program& plain = both[0][which.skin][which.part];
  if (!which.decorated || refused_) return plain;
  Program& program = both[1][which.skin][which.part];
  if (program) return program;
  auto made = compiled(which);
  if (!made) {
    refused_ = true;
    remarks_.push_back("Decorated pots are drawn bare. " + to_text(made.error()));
    return plain;
  }
  return program = std::move(*made);
}

}  // namespace onggi::render
