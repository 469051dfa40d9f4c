#pragma once

#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// Smooths edges inside triangles. Between begin() and end(), alpha is the share of a pixel's
/// samples to draw, and those samples are opaque. For multisampled targets with a stencil.
class SoftEdges {
 public:
  static Result<SoftEdges> create();
  /// Set depth and blending before; the stencil's first bit stays free.
  void begin() const;
  /// Leaves the stencil test off.
  void end() const;

 private:
  /// GL_SAMPLE_ALPHA_TO_ONE is available; OpenGL ES needs an extension for it.
  bool by_driver_ = true;
  Program opaque_;
  Mesh all_;
};

}  // namespace onggi::render
