#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/clay/clay_mesh.h"
#include "engine/clay/clay_view.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/picture/render/frame_work.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/picture/view/measure.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::render {

struct WindowOptions {
  int width = 0, height = 0;  ///< Both 0: full screen on the primary monitor.
  bool visible = true;        ///< false: never mapped (scripted visits).
  std::string title = "Onggi";
};

/// Figures of the last second.
struct RenderStatus {
  double frame_ms = 0;        ///< Mean time to draw and present.
  double render_scale = 1;    ///< Of the 3-D picture, 0.35..1, chosen from the measured frame time.
  bool software = false;      ///< No GPU: llvmpipe or the like.
  bool full_quality = false;  ///< The last frame was drawn as finely as a GPU would.
  std::string device;         ///< GL_RENDERER.
  bool embedded = false;      ///< OpenGL ES, where the driver has no OpenGL 3.3.
  std::uint64_t frames = 0;
  std::uint64_t text_overflows = 0;  ///< Texts drawn that were larger than their box: 0 is right.
  std::string last_overflow;         ///< The latest of them.
  FrameWork work;                    ///< Since the window was opened.
  bool shading_counted = false;      ///< The driver can count shader runs.
};

/// Window, OpenGL 3.3 core and text. Main thread only.
class Renderer {
 public:
  /// Problem (exit 1) says which of display, GL version or shader is missing, and what to do.
  static Result<std::unique_ptr<Renderer>> create(const WindowOptions& options);
  virtual ~Renderer() = default;

  virtual int width() const = 0;  ///< Framebuffer pixels.
  virtual int height() const = 0;
  /// Everything since the last call, in order. Waits for nothing.
  virtual std::vector<view::InputEvent> poll() = 0;
  /// How many fingers the screen's glass tells apart at once; 0: it has none. Asks the display.
  virtual int fingers() const = 0;
  /// Once a frame: the monitor sleeps, or is awake. Nothing where it is not all ours.
  virtual void sleep(bool on) = 0;
  /// What staff should know of monitors and touch screens, a line each, once.
  virtual std::vector<std::string> remarks() = 0;

  /// The clay that is drawn from here on; nothing but the wheel before the first.
  virtual void show_clay(const ClayView& clay) = 0;
  /// Once a frame: what changed of it since. Costs by the rows that did.
  virtual void update_clay(const ClayView& clay) = 0;

  /// The vessel that view::PotView::beside shows from here on: `mesh` about the y axis, its foot at
  /// 0, times `size`, in linear `color` or, where that is not empty, in its own `coloring`.
  virtual void show_vessel(const TriangleMesh& mesh, std::array<float, 3> color,
                           const content::Coloring& coloring, double size) = 0;

  /// Draws into the window's back buffer.
  virtual void draw(const view::Frame& frame) = 0;
  virtual void present() = 0;
  /// The back buffer as drawn.
  virtual view::Image read_pixels() = 0;
  /// Draws `frame` (its own width and height, any up to 4096) off screen at full quality with the
  /// present grid.
  virtual view::Image draw_offscreen(const view::Frame& frame) = 0;
  /// What the surface of the clay that is shown is at each position of `mesh`, which is its own:
  /// dry clay, or fired in `glazing`. By the shader that draws it, so they are one.
  virtual std::vector<view::SkinPoint> read_skin(const ClayMesh& mesh,
                                                 const std::optional<view::Glazing>& glazing) = 0;

  /// A picture of a mesh on a transparent ground with its soft shadow, studio light, linear base
  /// `color`, or in its own `coloring` where that is not empty.
  virtual view::PictureId make_picture(const TriangleMesh& mesh, std::array<float, 3> color,
                                       const content::Coloring& coloring, int width,
                                       int height) = 0;
  virtual view::PictureId make_picture(const view::Image& image) = 0;
  virtual void drop_picture(view::PictureId id) = 0;

  virtual const view::TextMeasure& measure() const = 0;
  virtual RenderStatus status() const = 0;
  /// true: always full render scale (scripted visits, where time is no matter).
  virtual void set_full_quality(bool on) = 0;
  /// true: RenderStatus::work has the shader runs of the frames from here on. Waits for each.
  virtual void count_shading(bool on) = 0;
};

}  // namespace onggi::render
