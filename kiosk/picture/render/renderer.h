#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/clay/clay_mesh.h"
#include "engine/clay/clay_view.h"
#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/collection/decoration/coat_picture.h"
#include "kiosk/picture/render/frame_work.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"
#include "kiosk/picture/view/input.h"
#include "kiosk/picture/view/measure.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::render {

struct Portrait;

struct WindowOptions {
  int width = 0, height = 0;  ///< Both 0: full screen on the primary monitor.
  bool visible = true;        ///< false: the window is never mapped (scripted visits).
  std::string title = "Onggi";
  /// What a visible window of this width and height shows while the shaders are compiled, which
  /// takes seconds without a GPU: items only. Absent: nothing.
  std::function<view::Frame(int, int)> opening = {};
};

/// Figures of the last second.
struct RenderStatus {
  double frame_ms = 0;        ///< Mean time to draw and present.
  double render_scale = 1;    ///< Scale of the 3-D picture, 0.35..1, from the measured frame time.
  bool software = false;      ///< No GPU: llvmpipe or similar.
  bool full_quality = false;  ///< The last frame was drawn in the full quality of a GPU.
  std::string device;         ///< GL_RENDERER.
  bool embedded = false;      ///< OpenGL ES, if the driver has no OpenGL 3.3.
  std::uint64_t frames = 0;
  std::uint64_t text_overflows = 0;  ///< Drawn texts larger than their box: must be 0.
  std::string last_overflow;         ///< The last of them.
  FrameWork work;                    ///< Since the window was opened.
  bool shading_counted = false;      ///< The driver can count shader runs.
};

/// Window, OpenGL 3.3 core and text. Main thread only.
class Renderer {
 public:
  /// Problem (exit 1) names the missing part (display, GL version or shader) and the remedy.
  static Result<std::unique_ptr<Renderer>> create(const WindowOptions& options);
  virtual ~Renderer() = default;

  virtual int width() const = 0;  ///< Framebuffer pixels.
  virtual int height() const = 0;
  /// All input since the last call, in order. Does not wait.
  virtual std::vector<view::InputEvent> poll() = 0;
  /// Fingers that the touch screen can follow at once; 0: no touch screen. Asks the display.
  virtual int fingers() const = 0;
  /// Call once a frame: turns the monitor off or on. Does nothing unless the kiosk has the whole
  /// screen.
  virtual void sleep(bool on) = 0;
  /// Messages about monitors and touch screens for staff, each once.
  virtual std::vector<std::string> remarks() = 0;

  /// Sets the clay to draw; before the first one only the wheel is drawn.
  virtual void show_clay(const ClayView& clay) = 0;
  /// Call once a frame: uploads its changes. The cost depends on the changed rows.
  virtual void update_clay(const ClayView& clay) = 0;
  /// Call once a frame before draw(): the decoration of the clay that is shown; null: none. Uploads
  /// the tiles that have changed. `coat` need only live during the call.
  virtual void show_decoration(const decoration::CoatPicture* coat) = 0;

  /// Sets the vessel for view::PotView::beside: `mesh` about the y axis, its foot at 0, scaled by
  /// `size`, in linear `color`, or in its `coloring` if that is not empty.
  virtual void show_vessel(const TriangleMesh& mesh, std::array<float, 3> color,
                           const content::Coloring& coloring, double size) = 0;

  virtual void draw(const view::Frame& frame) = 0;
  virtual void present() = 0;
  /// The back buffer as drawn.
  virtual view::Image read_pixels() = 0;
  /// Makes a part of the room that draw_offscreen(frame) needs; true: call it again. For a large
  /// picture call it once a frame: without a GPU all of it takes three quarters of a second.
  virtual bool prepare_offscreen(const view::Frame& frame) = 0;
  /// Draws `frame` (its own width and height, up to 4096) off screen at full quality with the
  /// current grid. The room stays for the next picture of its size, and some frames long.
  virtual view::Image draw_offscreen(const view::Frame& frame) = 0;
  /// The clay's surface at each position of `mesh`, which must belong to the shown clay: dry, or
  /// fired in `glazing`. Uses the shader that draws the clay, so that both agree.
  virtual std::vector<view::SkinPoint> read_skin(const ClayMesh& mesh,
                                                 const std::optional<view::Glazing>& glazing) = 0;

  /// Uploads a mesh for draw_picture(): linear base `color`, or its `coloring` if that is not
  /// empty, framed in width x height pixels. Keep it no longer than the renderer. For a scan each
  /// of the two takes up to 0.4 s without a GPU: call them in two frames.
  virtual std::shared_ptr<const Portrait> prepare_picture(const TriangleMesh& mesh,
                                                          std::array<float, 3> color,
                                                          const content::Coloring& coloring,
                                                          int width, int height) = 0;
  /// A picture of it on a transparent ground with its soft shadow, in studio light.
  virtual view::PictureId draw_picture(const Portrait& portrait) = 0;
  virtual view::PictureId make_picture(const view::Image& image) = 0;
  virtual void drop_picture(view::PictureId id) = 0;

  virtual const view::TextMeasure& measure() const = 0;
  virtual RenderStatus status() const = 0;
  /// True: always full render scale (scripted visits, where time does not matter).
  virtual void set_full_quality(bool on) = 0;
  /// True: from now on RenderStatus::work counts shader runs. Waits for each run.
  virtual void count_shading(bool on) = 0;
};

}  // namespace onggi::render
