#include "kiosk/ground/files/output_kind.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace onggi::files {
namespace {

constexpr std::size_t kLongestJson = std::size_t{64} << 20;
constexpr std::size_t kHead = 4096;
constexpr std::string_view kPng = "\x89PNG\r\n";

bool is_report(const std::string& text) {
  using Json = nlohmann::json;
  // Drop deeper values, because the top keys are enough to recognise a glTF.
  const auto shallow = [](int depth, Json::parse_event_t, Json&) { return depth <= 1; };
  const Json json = Json::parse(text, shallow, false);
  return !json.is_discarded() && !(json.is_object() && json.contains("asset"));
}

/// Commas outside quotes.
std::ptrdiff_t commas(std::string_view line) {
  std::ptrdiff_t n = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) ++n;
  }
  return n;
}

/// True if all whole lines have the same number of commas, at least one.
bool is_table(std::string_view head) {
  const auto unprintable = [](unsigned char c) {
    return c < 0x20 && c != '\n' && c != '\r' && c != '\t';
  };
  if (std::any_of(head.begin(), head.end(), unprintable)) return false;
  std::size_t from = 0, end = head.find('\n');
  if (end == std::string_view::npos) return false;
  const std::ptrdiff_t wanted = commas(head.substr(0, end));
  bool good = wanted > 0;
  for (; good && end != std::string_view::npos; from = end + 1, end = head.find('\n', from))
    good = commas(head.substr(from, end - from)) == wanted;
  return good;
}

std::string read_to(std::ifstream& in, std::size_t most) {
  std::string text(most, '\0');
  in.read(text.data(), static_cast<std::streamsize>(most));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

/// A head of 80 bytes, the number of triangles, and 50 bytes for each.
bool is_stl(std::ifstream& in, const std::string& head) {
  if (head.size() < 84) return false;
  std::uint64_t triangles = 0;
  for (std::size_t n = 4; n-- > 0;)
    triangles = triangles << 8 | static_cast<unsigned char>(head[80 + n]);
  in.clear();
  in.seekg(0, std::ios::end);
  return static_cast<std::uint64_t>(in.tellg()) == 84 + 50 * triangles;
}

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return ending;
}

struct Ending {
  std::string_view text;
  std::optional<Output::Kind> kind;  // none: this program writes no such file
};
constexpr Ending kEndings[] = {{".json", Output::Kind::json},
                               {".csv", Output::Kind::csv},
                               {".png", Output::Kind::picture},
                               {".svg", Output::Kind::picture},
                               {".glb", Output::Kind::glb},
                               {".wav", Output::Kind::wav},
                               {".gz", Output::Kind::archive},
                               {".tgz", Output::Kind::archive},
                               {".gif", {}},
                               {".jpg", {}},
                               {".jpeg", {}},
                               {".webp", {}},
                               {".bmp", {}},
                               {".tif", {}},
                               {".tiff", {}},
                               {".pdf", {}},
                               {".ps", {}},
                               {".eps", {}},
                               {".gltf", {}},
                               {".obj", {}},
                               {".stl", Output::Kind::stl},
                               {".ply", {}},
                               {".mp3", {}},
                               {".ogg", {}},
                               {".flac", {}},
                               {".zip", {}},
                               {".xz", {}},
                               {".bz2", {}},
                               {".zst", {}},
                               {".tar", {}},
                               {".toml", {}},
                               {".onggi", {}},
                               {".xml", {}},
                               {".html", {}},
                               {".md", {}},
                               {".xls", {}},
                               {".xlsx", {}},
                               {".ods", {}},
                               {".tsv", {}},
                               {".yaml", {}},
                               {".yml", {}}};

}  // namespace

bool is_svg(const std::filesystem::path& file) { return ending_of(file) == ".svg"; }

bool name_agrees(const std::filesystem::path& file, Output::Kind kind) {
  const std::string ending = ending_of(file);
  const auto* const known = std::ranges::find(kEndings, ending, &Ending::text);
  if (kind == Output::Kind::png && ending == ".svg") return false;
  return known == std::end(kEndings) || known->kind == kind ||
         (kind == Output::Kind::png && known->kind == Output::Kind::picture);
}

bool is_of_kind(const std::filesystem::path& file, Output::Kind kind) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  const std::string head = read_to(in, kHead);
  if (head.empty()) return in.eof();
  const bool whole = head.size() < kHead;
  switch (kind) {
    case Output::Kind::json: {
      if (whole) return is_report(head);
      const std::string rest = read_to(in, kLongestJson);
      return rest.size() < kLongestJson && is_report(head + rest);
    }
    case Output::Kind::csv:
      return is_table(head);
    case Output::Kind::glb:
      return head.starts_with("glTF");
    case Output::Kind::wav:
      return head.starts_with("RIFF") && head.substr(8, 4) == "WAVE";
    case Output::Kind::archive:
      return head.starts_with("\x1f\x8b");
    case Output::Kind::stl:
      return is_stl(in, head);
    case Output::Kind::png:
      return head.starts_with(kPng);
    case Output::Kind::picture:
      break;
  }
  if (is_svg(file)) return head.find("<svg") != std::string::npos;
  return head.starts_with(kPng);
}

}  // namespace onggi::files
