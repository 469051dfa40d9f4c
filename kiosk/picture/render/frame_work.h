#pragma once

#include <cstdint>

namespace onggi::render {

/// Graphics work. Totals since the window was opened; a frame's work is the difference of two.
struct FrameWork {
  std::uint64_t draws = 0;     ///< Draw calls.
  std::uint64_t vertices = 0;  ///< Vertices in them, by their indices.
  std::uint64_t bytes = 0;     ///< Uploaded into buffers and textures.
  std::uint64_t switches = 0;  ///< Programs, textures, vertex arrays and framebuffers bound.
  std::uint64_t copied = 0;    ///< Pixels copied between framebuffers.
  /// Shader runs as counted by the driver (ARB_pipeline_statistics_query). Counted only while
  /// Renderer::count_shading is on; 0 if the driver cannot count.
  std::uint64_t vertex_runs = 0, fragment_runs = 0;
  friend bool operator==(const FrameWork&, const FrameWork&) = default;
};

inline FrameWork operator-(FrameWork a, const FrameWork& b) {
  a.draws -= b.draws;
  a.vertices -= b.vertices;
  a.bytes -= b.bytes;
  a.switches -= b.switches;
  a.copied -= b.copied;
  a.vertex_runs -= b.vertex_runs;
  a.fragment_runs -= b.fragment_runs;
  return a;
}

}  // namespace onggi::render
