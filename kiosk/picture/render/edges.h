#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/outline.h"

namespace onggi::render {

/// Smooth edges on a 3-D picture that is drawn with one sample a pixel, smaller than the frame.
/// Each outline is a narrow ribbon over the composed picture, at the frame's full size.
class Edges {
 public:
  static Result<std::unique_ptr<Edges>> create();

  /// Finds and uploads the outlines for a picture that is `scale` times the camera's size. Binds
  /// the target of the strips and clears it, for draw_wall() and draw_wheel() with the programs of
  /// clay.glsl and wheel.glsl, and for the lip.
  void prepare(const ClaySurface& clay, const view::PotView& pot, const glm::mat4& clip,
               double scale);
  /// Place of the unrolled lip among the strips: its size and its lower left, for clay.glsl.
  static glm::vec4 unrolled_lip();
  void draw_wall() const { draw_strips(0, wall_); }
  void draw_wheel() const { draw_strips(wall_, wheel_); }
  /// Draws them into the bound target, which shows `space` over `ground` and is a whole frame.
  void draw(const Target& space, const Texture& ground, float opacity, int width, int height);

 private:
  Edges() = default;
  void draw_strips(std::size_t first, std::size_t count) const;
  /// Corners and indices on the graphics side, and how many have room.
  struct Buffers {
    ArrayName array;
    BufferName corners, indices;
    std::size_t room = 0, index_room = 0;
    void create();
  };
  Program program_;
  Target strips_target_;
  Buffers ribbons_, strips_;
  Ribbons now_, uploaded_;
  std::vector<std::uint32_t> strip_indices_, uploaded_strip_indices_;
  std::size_t wall_ = 0, wheel_ = 0;
  float wide_ = 1;
  glm::vec2 distance_of_{0.0f};
};

}  // namespace onggi::render
