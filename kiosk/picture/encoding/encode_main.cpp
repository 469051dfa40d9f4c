// onggi-encode: the only program that links OpenImageIO.
//
//   onggi-encode < header-and-pixels > picture
//   onggi-encode --describe FILE       the content of FILE as another reader sees it, as JSON
//
// Standard input: one line of JSON {width, height, format: png|jpeg|gif, title, copyright,
// description, software, and for a gif: frames, hundredths (of a second for each)}, then width *
// height * 4 bytes of sRGB with straight alpha for each frame. Exit 0, or 1 with the reason on
// standard error. It never writes a file, because OpenImageIO does not report a full disk.

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/picture/encoding/gif.h"
#include "kiosk/picture/encoding/picture_bytes.h"

namespace {

using onggi::encoding::Caption;
using onggi::encoding::Format;
using onggi::encoding::kLargestSide;
using onggi::encoding::kMostFrames;

constexpr int kJpegQuality = 92;
constexpr std::size_t kLongestText = 1000;  // bytes; a JPEG's metadata must fit into 64 KiB
constexpr float kDotsPerInch = 300.0f;      // 1500 x 2100 is then a postcard of 5 x 7 inches

struct Order {
  int width = 0, height = 0;
  Format format = Format::png;
  int frames = 1, hundredths = 0;
  Caption caption;
  std::string software;
  std::vector<unsigned char> rgba;
};

/// The fault, or "".
std::string read_order(std::istream& in, Order& order) {
  std::string line;
  if (!std::getline(in, line)) return "there is no header";
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object()) return "the header is not JSON";
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    std::string value =
        found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
    std::size_t end = std::min(value.size(), kLongestText);
    while (end < value.size() && (static_cast<unsigned char>(value[end]) & 0xC0) == 0x80) --end;
    value.resize(end);
    return value;
  };
  const auto side = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number_integer() ? found->get<long long>() : 0LL;
  };
  if (side("width") < 1 || side("width") > kLargestSide || side("height") < 1 ||
      side("height") > kLargestSide) {
    return "width and height must be 1 to " + std::to_string(kLargestSide);
  }
  order.width = static_cast<int>(side("width"));
  order.height = static_cast<int>(side("height"));
  const std::string format = text("format");
  if (format != "png" && format != "jpeg" && format != "gif")
    return "the format must be png, jpeg or gif";
  order.format = format == "png" ? Format::png : format == "jpeg" ? Format::jpeg : Format::gif;
  if (order.format == Format::gif) {
    if (side("frames") < 1 || side("frames") > kMostFrames)
      return "frames must be 1 to " + std::to_string(kMostFrames);
    if (side("hundredths") < 2 || side("hundredths") > 1000)
      return "a frame must last 2 to 1000 hundredths of a second";
    order.frames = static_cast<int>(side("frames"));
    order.hundredths = static_cast<int>(side("hundredths"));
  }
  order.caption = {text("title"), text("copyright"), text("description")};
  order.software = text("software");
  order.rgba.resize(4 * static_cast<std::size_t>(order.width) *
                    static_cast<std::size_t>(order.height) *
                    static_cast<std::size_t>(order.frames));
  in.read(reinterpret_cast<char*>(order.rgba.data()),
          static_cast<std::streamsize>(order.rgba.size()));
  if (static_cast<std::size_t>(in.gcount()) != order.rgba.size()) return "pixels are missing";
  return "";
}

bool has_alpha(const std::vector<unsigned char>& rgba) {
  for (std::size_t i = 3; i < rgba.size(); i += 4) {
    if (rgba[i] != 255) return true;
  }
  return false;
}

/// Three channels; transparent pixels are laid on white.
std::vector<unsigned char> on_white(const std::vector<unsigned char>& rgba) {
  std::vector<unsigned char> rgb;
  rgb.reserve(rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    const int a = rgba[i + 3];
    for (std::size_t k = 0; k < 3; ++k) {
      rgb.push_back(static_cast<unsigned char>((rgba[i + k] * a + 255 * (255 - a) + 127) / 255));
    }
  }
  return rgb;
}

/// PNG gets its texts afterwards. JPEG gets Exif (description, with the title first) and IPTC.
void describe_picture(const Order& order, OIIO::ImageSpec& spec) {
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("oiio:UnassociatedAlpha", 1);
  spec.attribute("XResolution", kDotsPerInch);
  spec.attribute("YResolution", kDotsPerInch);
  spec.attribute("ResolutionUnit", "in");
  if (order.format == Format::png) return;
  spec.attribute("Compression", "jpeg:" + std::to_string(kJpegQuality));
  spec.attribute("jpeg:subsampling", "4:4:4");  // hairlines and small print keep their colour
  // An empty text makes OpenImageIO fail an assertion.
  const auto tell = [&](const char* name, const std::string& text) {
    if (!text.empty()) spec.attribute(name, text);
  };
  const std::string& title = order.caption.title;
  const std::string& more = order.caption.description;
  tell("ImageDescription", title.empty() || more.empty() ? title + more : title + ". " + more);
  tell("Copyright", order.caption.copyright);
  tell("Software", order.software);
  tell("IPTC:ObjectName", title);
}

/// The bytes of an animated GIF, from our own writer: OpenImageIO's output differs each time, and
/// its palette for each picture makes still parts flicker.
std::vector<std::byte> encode_turning(const Order& order) {
  const std::vector<std::byte> gif =
      onggi::encoding::write_gif(order.width, order.height, order.hundredths, on_white(order.rgba));
  return onggi::encoding::with_comments(gif, order.caption, order.software);
}

/// The picture's bytes; if there are none, `fault` has the reason.
std::vector<std::byte> encode(const Order& order, std::string& fault) {
  if (order.format == Format::gif) return encode_turning(order);
  const bool alpha = order.format == Format::png && has_alpha(order.rgba);
  const std::vector<unsigned char> rgb =
      alpha ? std::vector<unsigned char>() : on_white(order.rgba);
  OIIO::ImageSpec spec(order.width, order.height, alpha ? 4 : 3, OIIO::TypeDesc::UINT8);
  describe_picture(order, spec);

  const char* const name = order.format == Format::png ? "postcard.png" : "postcard.jpg";
  std::vector<unsigned char> memory;
  OIIO::Filesystem::IOVecOutput stream(memory);
  const auto output = OIIO::ImageOutput::create(name, &stream);
  if (!output || !output->supports("ioproxy")) {
    fault = "OpenImageIO cannot write this format to memory: " + OIIO::geterror();
    return {};
  }
  if (!output->open(name, spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, alpha ? order.rgba.data() : rgb.data()) ||
      !output->close()) {
    fault = output->geterror();
    return {};
  }
  const auto bytes = std::as_bytes(std::span(memory));
  if (!onggi::encoding::is_whole(bytes, order.format)) {
    fault = "OpenImageIO gave an incomplete picture";
    return {};
  }
  if (order.format == Format::png) {
    return onggi::encoding::with_texts(bytes, order.caption, order.software);
  }
  return {bytes.begin(), bytes.end()};
}

int describe(const char* file) {
  // As in the file: otherwise OpenImageIO multiplies colour by alpha, each version in its own way.
  OIIO::ImageSpec as_it_is;
  as_it_is.attribute("oiio:UnassociatedAlpha", 1);
  const auto input = OIIO::ImageInput::open(file, &as_it_is);
  if (!input) {
    std::cerr << "onggi-encode: " << onggi::terminal::plain(OIIO::geterror()) << "\n";
    return 1;
  }
  const OIIO::ImageSpec& spec = input->spec();
  nlohmann::json json{{"width", spec.width},
                      {"height", spec.height},
                      {"channels", spec.nchannels},
                      {"format", input->format_name()}};
  for (const auto& attribute : spec.extra_attribs) {
    json["metadata"][attribute.name().string()] = attribute.get_string();
  }
  std::vector<unsigned char> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, pixels.data())) {
    std::cerr << "onggi-encode: " << onggi::terminal::plain(input->geterror()) << "\n";
    return 1;
  }
  const std::size_t few = std::min<std::size_t>(pixels.size(), 64);
  json["first"] =
      std::vector<int>(pixels.begin(), pixels.begin() + static_cast<std::ptrdiff_t>(few));
  std::cout << json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && std::string(argv[1]) == "--describe") return describe(argv[2]);
  if (argc != 1) {
    std::cerr << "onggi-encode: the kiosk starts this program. To see what a picture holds:\n"
                 "  onggi-encode --describe postcard.png\n";
    return 2;
  }
  // The kiosk needs the other core for the clay.
  OIIO::attribute("threads", 1);
  std::ios::sync_with_stdio(false);
  Order order;
  std::string fault = read_order(std::cin, order);
  std::vector<std::byte> picture;
  if (fault.empty()) picture = encode(order, fault);
  if (!fault.empty()) {
    std::cerr << "onggi-encode: " << fault << "\n";
    return 1;
  }
  const bool written = std::fwrite(picture.data(), 1, picture.size(), stdout) == picture.size() &&
                       std::fflush(stdout) == 0;
  return written ? 0 : 1;
}
