#pragma once

namespace onggi::view {

/// Text sizes, each 1.333 times the one before. Body text is the smallest that visitors can read at
/// the exhibit's distance: capitals of 0.7 degrees.
class TypeScale {
 public:
  /// Pixels (em) of body text on a screen of `width` x `height` pixels with a diagonal of
  /// `diagonal_mm`, read from `distance_mm`. At most 1/18 of the short side, so that a stated
  /// distance that is too large still leaves space for words.
  static TypeScale for_screen(int width, int height, double diagonal_mm, double distance_mm);

  explicit TypeScale(float body_px) : body_(body_px) {}

  /// 0 body, 1 lead, 2 heading, 3 title, 4 poster; -1 small print (postcards, not screens).
  float px(int step) const;
  float body() const { return body_; }

 private:
  float body_;
};

}  // namespace onggi::view
