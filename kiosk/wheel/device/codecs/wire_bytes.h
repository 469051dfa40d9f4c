#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace onggi::device {

/// The bytes of one report, with its id first if it has one.
using Report = std::span<const std::uint8_t>;

/// Little-endian numbers at `at`; the caller has checked the length. No allocation.
constexpr std::uint16_t u16_at(Report bytes, std::size_t at) {
  return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
}
constexpr std::int16_t i16_at(Report bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16_at(bytes, at));
}
constexpr std::uint32_t u32_at(Report bytes, std::size_t at) {
  return static_cast<std::uint32_t>(u16_at(bytes, at)) |
         static_cast<std::uint32_t>(u16_at(bytes, at + 2)) << 16;
}
constexpr std::int32_t i32_at(Report bytes, std::size_t at) {
  return static_cast<std::int32_t>(u32_at(bytes, at));
}
constexpr void put_u16(std::span<std::uint8_t> bytes, std::size_t at, std::uint16_t value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xff);
  bytes[at + 1] = static_cast<std::uint8_t>(value >> 8);
}
constexpr void put_i16(std::span<std::uint8_t> bytes, std::size_t at, std::int16_t value) {
  put_u16(bytes, at, static_cast<std::uint16_t>(value));
}
constexpr void put_u32(std::span<std::uint8_t> bytes, std::size_t at, std::uint32_t value) {
  put_u16(bytes, at, static_cast<std::uint16_t>(value & 0xffff));
  put_u16(bytes, at + 2, static_cast<std::uint16_t>(value >> 16));
}

enum class ReportResult : std::uint8_t {
  news,     ///< It was read and has new data.
  nothing,  ///< A foreign report, or one without new data: an old one, a battery's.
  broken    ///< Too short, or a wrong checksum: the device's data cannot be trusted.
};

}  // namespace onggi::device
