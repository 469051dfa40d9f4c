#include "kiosk/picture/encoding/picture_bytes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

#include "kiosk/ground/files/crc32.h"

namespace onggi::encoding {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n"sv;
constexpr std::string_view kPngEnd = "\0\0\0\0IEND\xae\x42\x60\x82"sv;
constexpr std::string_view kJpegStart = "\xff\xd8\xff"sv;
constexpr std::string_view kJpegEnd = "\xff\xd9"sv;
constexpr std::string_view kGifStart = "GIF89a"sv;
// The end of the last picture's data, and of the file
constexpr std::string_view kGifEnd = "\0\x3b"sv;
constexpr std::size_t kGifHead = 13;  // signature and screen descriptor
// Signature, then IHDR: length 4, name 4, data 13, checksum 4.
constexpr std::size_t kBehindHeader = 8 + 4 + 4 + 13 + 4;

bool starts_and_ends(std::span<const std::byte> bytes, std::string_view start,
                     std::string_view end) {
  const std::string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return all.size() >= start.size() + end.size() && all.starts_with(start) && all.ends_with(end);
}

std::string big_endian(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
          static_cast<char>(v)};
}

/// PNG specification 11.3.4: a keyword and its text. iTXt: not compressed, no language tag, UTF-8.
std::string text_chunk(std::string_view keyword, std::string_view text) {
  const bool ascii = std::all_of(text.begin(), text.end(),
                                 [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  std::string body(ascii ? "tEXt" : "iTXt");
  body += keyword;
  body += ascii ? "\0"sv : "\0\0\0\0\0"sv;
  body += text;
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(body.data()), body.size());
  return big_endian(static_cast<std::uint32_t>(body.size() - 4)) + body +
         big_endian(files::crc32(bytes));
}

}  // namespace

bool is_whole(std::span<const std::byte> bytes, Format format) {
  if (format == Format::gif)
    return starts_and_ends(bytes, kGifStart, kGifEnd) && bytes.size() > kGifHead;
  return format == Format::png ? starts_and_ends(bytes, kPngStart, kPngEnd) &&
                                     bytes.size() > kBehindHeader + kPngEnd.size()
                               : starts_and_ends(bytes, kJpegStart, kJpegEnd);
}

std::vector<std::byte> with_texts(std::span<const std::byte> png, const Caption& caption,
                                  const std::string& software) {
  std::string chunks;
  const std::array<std::pair<std::string_view, std::string_view>, 4> texts{
      {{"Title", caption.title},
       {"Copyright", caption.copyright},
       {"Description", caption.description},
       {"Software", software}}};
  for (const auto& [keyword, text] : texts) {
    if (!text.empty()) chunks += text_chunk(keyword, text);
  }
  std::vector<std::byte> out(png.begin(), png.begin() + kBehindHeader);
  out.reserve(png.size() + chunks.size());
  std::transform(chunks.begin(), chunks.end(), std::back_inserter(out),
                 [](char c) { return static_cast<std::byte>(c); });
  out.insert(out.end(), png.begin() + kBehindHeader, png.end());
  return out;
}

std::vector<std::byte> with_comments(std::span<const std::byte> gif, const Caption& caption,
                                     const std::string& software) {
  std::string comments;
  for (const std::string& text :
       {caption.title, caption.copyright, caption.description, software}) {
    if (text.empty()) continue;
    // GIF89a, 24: blocks of up to 255 bytes, each after its length, until a block of length 0.
    comments += "\x21\xfe"sv;
    for (std::size_t at = 0; at < text.size(); at += 255) {
      const std::string part = text.substr(at, 255);
      comments += static_cast<char>(part.size());
      comments += part;
    }
    comments += '\0';
  }
  // At the end: some viewers require the loop extension to come first.
  std::vector<std::byte> out(gif.begin(), gif.end() - 1);
  out.reserve(gif.size() + comments.size());
  std::transform(comments.begin(), comments.end(), std::back_inserter(out),
                 [](char c) { return static_cast<std::byte>(c); });
  out.push_back(gif.back());
  return out;
}

}  // namespace onggi::encoding
