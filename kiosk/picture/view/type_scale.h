#pragma once

namespace onggi::view {

/// Sizes of text, each 1.333 times the one before. The body size is the smallest that a visitor
/// reads at the exhibit's distance: capitals of 0.7 degrees.
class TypeScale {
 public:
  /// Pixels (em) of body text on a screen of `width` x `height` pixels whose diagonal measures
  /// `diagonal_mm`, read from `distance_mm`. Never more than 1/18 of the short side, so that a
  /// stated distance too far for the screen still leaves room for words.
  static TypeScale for_screen(int width, int height, double diagonal_mm, double distance_mm);

  explicit TypeScale(float body_px) : body_(body_px) {}

  /// 0 body, 1 lead, 2 heading, 3 title, 4 poster; -1 small print (postcards, not screens).
  float px(int step) const;
  float body() const { return body_; }

 private:
  float body_;
};

}  // namespace onggi::view
