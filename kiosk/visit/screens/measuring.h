#pragma once

#include <string>
#include <unordered_map>

#include "kiosk/picture/view/measure.h"

namespace onggi::screens {

/// Caches text sizes, because a screen sets the same words sixty times a second, and measures only
/// so many bytes of new words a frame, so that no frame waits for words, whatever file they are of.
class Measuring {
 public:
  /// Bytes of words a frame, each text counted with kEach more. The exhibit's own pages need at
  /// most three quarters of it (tests/kiosk/visit/screens/fonts_test.cpp).
  static constexpr std::size_t kMostBytes = 64 * 1024, kEach = 64;

  explicit Measuring(const view::TextMeasure& measure) : measure_(measure) {}
  void begin_frame() { bytes_ = 0; }
  /// In a frame that has measured its share, a text that is new gets a guessed size.
  view::TextMeasure::Size operator()(const std::string& words, const view::TextStyle& style,
                                     float width);
  /// This frame has measured its share: what was laid out since may be guessed.
  bool spent() const { return bytes_ >= kMostBytes; }
  std::size_t bytes() const { return bytes_; }  ///< Measured in this frame.

 private:
  using Sizes = std::unordered_map<std::string, view::TextMeasure::Size>;

  const view::TextMeasure& measure_;
  std::size_t bytes_ = 0;
  Sizes known_, older_;  ///< What was not asked for since `known_` was last full goes.
};

}  // namespace onggi::screens
