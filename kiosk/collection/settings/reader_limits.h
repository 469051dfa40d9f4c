#pragma once

namespace onggi::settings {

/// Limits for a vessel's file: [reader] of an exhibit. A file beyond one of them is refused by name
/// before memory is allocated. The defaults are ten times what a careful scan needs and a tenth of
/// a kiosk's memory.
struct ReaderLimits {
  int file_mb = 512;            ///< MiB of a file, and of all buffers of a glTF together, 1..4096.
  int json_mb = 64;             ///< MiB of a glTF's JSON, 1..1024.
  int json_depth = 64;          ///< Brackets within brackets in it, 8..256.
  int json_values = 2'000'000;  ///< Values in it, 1000..100000000.
  int vertices = 16'777'216;    ///< In all of its nodes together, 1000..100000000.
  int triangles = 16'777'216;   ///< In all of its nodes together, 1000..100000000.
  int vessels_in_a_file = 64;   ///< Most vessels from one file, 1..1000.
  int texture_px = 8192;        ///< Longest side of a picture in it, 0..16384; 0: none are read.
  friend bool operator==(const ReaderLimits&, const ReaderLimits&) = default;
};

}  // namespace onggi::settings
