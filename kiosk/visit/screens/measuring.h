#pragma once

#include <string>
#include <unordered_map>

#include "kiosk/picture/view/measure.h"

namespace onggi::screens {

/// Caches text sizes, because a screen lays out the same words sixty times a second. Measures only
/// so many bytes of new words per frame, so that no frame waits for words, whatever file they come
/// from.
class Measuring {
 public:
  /// Bytes of words per frame; each text, and each change of writing in it (as from Arabic to
  /// Chinese), counts kEach more; each writing that a size of a font has not set yet, kWriting
  /// more: its letters are looked for in every font of the machine. The exhibit's own pages need
  /// at most three quarters of it (tests/kiosk/visit/screens/fonts_test.cpp).
  static constexpr std::size_t kMostBytes = 64 * 1024, kEach = 64, kWriting = 1024;

  explicit Measuring(const view::TextMeasure& measure) : measure_(measure) {}
  void begin_frame() { bytes_ = 0; }
  /// After a frame's share is used up, a new text gets a guessed size.
  view::TextMeasure::Size operator()(const std::string& words, const view::TextStyle& style,
                                     float width);
  /// This frame's share is used up: sizes since then may be guesses.
  bool spent() const { return bytes_ >= kMostBytes; }
  std::size_t bytes() const { return bytes_; }  ///< Measured in this frame.

 private:
  using Sizes = std::unordered_map<std::string, view::TextMeasure::Size>;

  /// How many writings of `words` the font has not set, or so long ago that Pango has dropped them.
  std::size_t new_writings(const std::string& font, const std::string& words);

  const view::TextMeasure& measure_;
  std::size_t bytes_ = 0;
  /// Of each size of a font, a bit each; when there are many, they replace the older ones.
  std::unordered_map<std::string, unsigned> writings_, older_writings_;
  std::size_t sets_ = 0;  ///< Bits in writings_.
  Sizes known_, older_;  ///< When `known_` is full, it replaces `older_`; sizes not asked for since
                         ///< then are dropped.
};

}  // namespace onggi::screens
