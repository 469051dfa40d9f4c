#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "kiosk/collection/decoration/coat_picture.h"
#include "kiosk/picture/render/gl.h"

namespace onggi::render {

/// A pot's decoration on the graphics side: two textures, each with two reduced levels, and the
/// table that finds a height's row in them. Only tiles that have changed are uploaded. What was
/// shown last stays uploaded while nothing is shown, so showing it again costs nothing.
class CoatTexture {
 public:
  static constexpr int kLevels = 3;

  /// Shows `coat`, or nothing where it is null. It need only live during the call.
  void show(const decoration::CoatPicture* coat);
  bool shown() const { return shown_; }
  /// Of what is shown: equal numbers look the same. 0: nothing.
  std::uint64_t change() const { return shown_ ? change_ : 0; }
  /// True if clay stands out of it, so that it moves the outline (CoatPicture::beads()).
  bool has_beads() const { return shown_ && has_beads_; }
  /// How far, m, as the shader reads it: `round` is the share of a turn, `up` of the height.
  float bead_at(float round, float up) const;
  /// Whether thin lines are smooth where the wall turns away from the eye (default) or in dots: up
  /// to eight reads of the textures a pixel, or two.
  void draw_fine(bool fine) { fine_ = fine; }
  /// Binds the textures to the unit and the three after it, and sets the current program's
  /// uniforms. `pixel`: size of a pixel on the clay, metres.
  void set(const Program& program, float pixel, int unit) const;

  /// Paint with its colour times its cover, so that filtered edges keep the paint's colour. Has the
  /// rows of whole tiles; those above the picture repeat its last one.
  const Texture& paint() const { return paint_; }
  const Texture& form() const { return form_; }

 private:
  void make_room(const decoration::CoatPicture& coat);
  void send(const decoration::CoatPicture& coat, int down, int from, int to);

  void show_beads(const decoration::CoatPicture& coat);

  Texture paint_, form_, rows_, bead_texture_;
  std::vector<std::uint8_t> beads_;
  bool has_beads_ = false;
  std::vector<std::uint64_t> changes_;  // of each tile, as uploaded
  std::vector<std::array<float, 2>> by_height_;
  int width_ = 0, height_ = 0;
  float floor_from_ = 0, floor_to_ = 0;
  bool shown_ = false, glazed_ = false, melted_ = false, fine_ = true;
  std::uint64_t change_ = 0;
};

}  // namespace onggi::render
