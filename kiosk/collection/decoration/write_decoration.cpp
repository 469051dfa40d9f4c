#include "kiosk/collection/decoration/write_decoration.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "kiosk/collection/textures/srgb.h"

namespace onggi::decoration {

namespace {

constexpr double kMillimetre = 1e-3, kMicrometre = 1e-6;  // m
constexpr double kPartsOfUnit = 1e4, kPartsOfShare = 1e6;
constexpr std::size_t kLineEnds = 110;  // letters

/// The shortest text without an exponent that is read as `value`, a finite number that a file has.
std::string number(double value) {
  char text[400];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, end.ptr};
}

/// The shortest text that is read as `value` m in units of `unit`.
std::string length_in(double value, double unit) {
  double read = 0.0;
  for (int digits = 1; digits <= 17; ++digits) {
    char text[40];
    const auto end =
        std::to_chars(text, text + sizeof text, value / unit, std::chars_format::general, digits);
    std::from_chars(text, end.ptr, read);
    if (unit * read == value) break;
  }
  return number(read);
}

std::string quoted_text(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00";
      out += kHex[byte / 16];
      out += kHex[byte % 16];
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// An id as a key.
std::string key_text(const std::string& id) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !id.empty() && std::ranges::all_of(id, plain) ? id : quoted_text(id);
}

std::string color_text(const std::array<float, 3>& linear) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string out = "\"#";
  for (const float light : linear) {
    const double value = std::clamp(textures::srgb_of_light(static_cast<double>(light)), 0.0, 1.0);
    const auto byte = static_cast<unsigned>(std::floor(255.0 * value + 0.5));
    out += kHex[byte / 16];
    out += kHex[byte % 16];
  }
  return out + '"';
}

/// Motifs by their order, each with an id of its own.
class Motifs {
 public:
  /// The id of `motif`; empty: it has nothing drawn.
  std::string id_of(const Motif& motif) {
    if (motif.drawn == Motif::Drawn{}) return {};
    for (const Named& one : all_)
      if (one.motif->drawn == motif.drawn) return one.id;
    const std::string wanted = motif.id.empty() ? "drawing" : motif.id;
    std::string id = wanted;
    for (int n = 2; std::ranges::find(all_, id, &Named::id) != all_.end(); ++n)
      id = wanted + "_" + std::to_string(n);
    all_.push_back({id, &motif});
    return id;
  }

  std::string text() const {
    std::string out;
    for (const Named& one : all_) {
      for (const auto& way : one.motif->drawn.fills) out += way_text(one.id, "fill", way);
      for (const auto& way : one.motif->drawn.lines) out += way_text(one.id, "line", way);
    }
    return out;
  }

 private:
  struct Named {
    std::string id;
    const Motif* motif;
  };

  static std::string way_text(const std::string& id, const char* name,
                              const Motif::Drawn::Way& way) {
    const bool sharp = std::ranges::all_of(way, &toml::OutlinePoint::corner);
    std::string out = "\n[[motif." + key_text(id) + "." + name + "]]\n";
    if (sharp) out += "smooth = false\n";
    std::string line = "points = [";
    for (std::size_t n = 0; n < way.size(); ++n) {
      const toml::OutlinePoint& p = way[n];
      std::string point = "[" + number(p.radius) + ", " + number(p.height);
      if (p.corner && !sharp) point += ", \"corner\"";
      point += n + 1 < way.size() ? "]," : "]";
      if (line.size() + point.size() > kLineEnds) {
        out += line + "\n";
        line = " ";
      }
      if (n > 0) line += ' ';
      line += point;
    }
    return out + line + "]\n";
  }

  std::vector<Named> all_;
};

class StepText {
 public:
  StepText(const Decoration& decoration, Motifs& motifs)
      : decoration_(decoration), motifs_(motifs) {}

  std::string text(const Step& step) {
    out_ = "\n[[step]]\n";
    put("do", quoted_text(kKindNames[static_cast<std::size_t>(step.kind)]));
    if (step.inside) put("side", "\"inside\"");
    switch (step.kind) {
      case Step::coat:
        coat(step);
        zone(step);
        break;
      case Step::smoke:
        put("from", number(step.from));
        length("soft_mm", step.soft);
        length("wander_mm", step.wander);
        put("seed", std::to_string(step.seed));
        break;
      case Step::band:
        coat(step);
        paint(step);
        at(step);
        break;
      case Step::coil:
        at(step);
        length("height_mm", step.height);
        put("marks", std::to_string(step.marks));
        break;
      case Step::burnish:
        if (step.zone) {
          zone(step);
          break;
        }
        at(step);
        motif(step);
        break;
      case Step::paint:
        coat(step);
        paint(step);
        if (step.load > 0.0) length("load_mm", step.load);
        at(step);
        motif(step);
        break;
      case Step::cut:
        at(step);
        motif(step);
        cut(step);
        break;
      case Step::stamp:
        at(step);
        motif(step);
        length("depth_mm", step.depth);
        break;
      case Step::wipe:
      case Step::resist:
      case Step::scrape:
        at(step);
        motif(step);
        break;
    }
    if (step.kind != Step::coat && step.kind != Step::smoke && step.kind != Step::stamp)
      length("width_mm", step.width);
    if (!step.says.empty()) put("says", quoted_text(step.says));
    return out_;
  }

 private:
  void put(const char* key, const std::string& value) {
    out_ += std::string(key) + " = " + value + "\n";
  }
  void length(const char* key, double value) { put(key, length_in(value, kMillimetre)); }
  void at(const Step& step) { put("at", number(step.at)); }
  void zone(const Step& step) {
    put("from", number(step.from));
    put("to", number(step.to));
  }
  void coat(const Step& step) {
    put("with", step.pigment == kGlaze
                    ? "\"glaze\""
                    : quoted_text(decoration_.pigments[static_cast<std::size_t>(step.pigment)].id));
    put("thickness_um", length_in(step.thickness, kMicrometre));
  }
  void paint(const Step& step) {
    if (step.fill > 0.0) put("fill", number(step.fill));
  }
  void motif(const Step& step) {
    const std::string id = motifs_.id_of(step.motif);
    if (!id.empty()) {
      put("motif", quoted_text(id));
      length("size_mm", step.size);
      put("turn", number(step.turn));
    }
    if (step.repeat != 1) put("repeat", std::to_string(step.repeat));
  }
  void cut(const Step& step) {
    length("depth_mm", step.depth);
    if (step.section == surface::CutDef::sunk)
      put("sunk", "true");
    else
      put("section", quoted_text(kSectionNames[static_cast<std::size_t>(step.section)]));
    if (step.teeth == 1) return;
    put("teeth", std::to_string(step.teeth));
    length("spacing_mm", step.spacing);
  }

  const Decoration& decoration_;
  Motifs& motifs_;
  std::string out_;
};

}  // namespace

double kept_length(double value, double unit) {
  return unit * (std::floor(value / unit * kPartsOfUnit + 0.5) / kPartsOfUnit);
}

double kept_share(double value) { return std::floor(value * kPartsOfShare + 0.5) / kPartsOfShare; }

std::string to_toml(const Decoration& decoration) {
  std::string out = "sources = " + quoted_text(decoration.sources) + "\n";
  out += "simplified = " + quoted_text(decoration.simplified) + "\n";
  out += "checked_by = " + quoted_text(decoration.checked_by) + "\n";
  out += "body = " + color_text(decoration.body) + "\n";
  out += "glaze = " + color_text(decoration.glaze) + "\n";
  for (const Pigment& pigment : decoration.pigments)
    out += "\n[pigment." + key_text(pigment.id) + "]\ncolor = " + color_text(pigment.color) +
           "\nhides_um = " + length_in(pigment.hides, kMicrometre) + "\n";
  Motifs motifs;
  StepText step_text(decoration, motifs);
  std::string steps;
  for (const Step& step : decoration.steps) steps += step_text.text(step);
  return out + motifs.text() + steps;
}

}  // namespace onggi::decoration
