#pragma once

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Between begin() and end() the alpha of what is drawn is the share of a pixel's samples that it
/// covers, and those are opaque: so edges in the middle of triangles are smooth. For targets with
/// samples and a stencil.
class SoftEdges {
 public:
  static Result<SoftEdges> create();
  /// Depth and blending are to be as they shall be drawn with; the stencil's first bit stays free.
  void begin() const;
  /// Leaves the stencil test off.
  void end() const;

 private:
  bool by_driver_ =
      true;  ///< It has GL_SAMPLE_ALPHA_TO_ONE, which OpenGL ES lacks but by extension.
  Program opaque_;
  Mesh all_;
};

}  // namespace onggi::render
