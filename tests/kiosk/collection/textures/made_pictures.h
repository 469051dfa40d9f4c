#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>

#include <jpeglib.h>
#include <webp/encode.h>

#include "kiosk/collection/textures/texture_pixels.h"

namespace onggi::textures::testing {

/// `upper` over `lower`, both of size x size / 2.
inline TexturePixels two_halves(int size, std::array<std::uint8_t, 3> upper,
                                std::array<std::uint8_t, 3> lower) {
  TexturePixels out;
  out.width = out.height = size;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const std::uint8_t c : y < size / 2 ? upper : lower) out.rgb.push_back(c);
  return out;
}

inline std::string big_endian(std::uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8),
          static_cast<char>(v)};
}

/// A chunk of a PNG with its check sum (ISO/IEC 15948, annex D).
inline std::string png_chunk(const std::string& kind, const std::string& data) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char c : kind + data) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? 0xEDB88320 ^ crc >> 1 : crc >> 1;
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + kind + data + big_endian(~crc);
}

inline const std::string kPngMark = "\x89PNG\r\n\x1A\n";

inline std::string png_head(std::uint32_t width, std::uint32_t height) {
  return kPngMark + png_chunk("IHDR", big_endian(width) + big_endian(height) +
                                          std::string("\x08\x02\0\0\0", 5));
}

/// A PNG whose data is not compressed; `more` are chunks before it.
inline std::string png_of(const TexturePixels& pixels, const std::string& more = "") {
  std::string rows;
  const auto stride = 3 * static_cast<std::size_t>(pixels.width);
  for (std::size_t at = 0; at < pixels.rgb.size(); at += stride)
    rows += '\0' + std::string(reinterpret_cast<const char*>(pixels.rgb.data()) + at, stride);
  std::uint32_t a = 1, b = 0;
  for (const char c : rows) {
    a = (a + static_cast<std::uint8_t>(c)) % 65521;
    b = (b + a) % 65521;
  }
  std::string data = "\x78\x01";
  for (std::size_t at = 0; at < rows.size(); at += 65535) {
    const std::size_t size = std::min<std::size_t>(65535, rows.size() - at);
    data += at + size == rows.size() ? '\1' : '\0';
    for (const std::size_t n : {size, ~size})
      data += {static_cast<char>(n & 255), static_cast<char>(n >> 8 & 255)};
    data += rows.substr(at, size);
  }
  data += big_endian(b << 16 | a);
  return png_head(static_cast<std::uint32_t>(pixels.width),
                  static_cast<std::uint32_t>(pixels.height)) +
         more + png_chunk("IDAT", data) + png_chunk("IEND", "");
}

inline std::string jpeg_of(const TexturePixels& pixels, int components = 3) {
  jpeg_compress_struct file{};
  jpeg_error_mgr errors{};
  file.err = jpeg_std_error(&errors);
  jpeg_create_compress(&file);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&file, &bytes, &size);
  file.image_width = static_cast<JDIMENSION>(pixels.width);
  file.image_height = static_cast<JDIMENSION>(pixels.height);
  file.input_components = components;
  file.in_color_space = components == 4 ? JCS_CMYK : JCS_RGB;
  jpeg_set_defaults(&file);
  jpeg_set_quality(&file, 95, TRUE);
  jpeg_start_compress(&file, TRUE);
  std::vector<unsigned char> row(static_cast<std::size_t>(components * pixels.width), 40);
  while (file.next_scanline < file.image_height) {
    if (components == 3)
      std::copy_n(pixels.rgb.begin() + static_cast<std::ptrdiff_t>(file.next_scanline * row.size()),
                  row.size(), row.begin());
    JSAMPROW at = row.data();
    jpeg_write_scanlines(&file, &at, 1);
  }
  jpeg_finish_compress(&file);
  jpeg_destroy_compress(&file);
  const std::string out(reinterpret_cast<const char*>(bytes), size);
  std::free(bytes);
  return out;
}

/// Without loss.
inline std::string webp_of(const TexturePixels& pixels) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeLosslessRGB(pixels.rgb.data(), pixels.width, pixels.height,
                                                 3 * pixels.width, &bytes);
  const std::string out(reinterpret_cast<const char*>(bytes), size);
  WebPFree(bytes);
  return out;
}

inline std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace onggi::textures::testing
