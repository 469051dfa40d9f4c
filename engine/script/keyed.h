#pragma once

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace onggi::script {

/// Angle of every scripted hand about the wheel, rad from x towards z: at the visitor's right, a
/// little in front.
inline constexpr double kHandAngle = 0.35;

/// Keys of a script, by rising time (s), and the position between two of them. A Key has `time` and
/// `phase`. Allocates nothing.
template <class Key>
class Keyed {
 public:
  /// At least two.
  explicit Keyed(std::vector<Key> keys) : keys_(std::move(keys)) {}

  struct Between {
    const Key& from;
    const Key& to;
    double share;  ///< 0..1
    double operator()(double a, double b) const { return a + share * (b - a); }
  };
  /// `t` must not fall from call to call.
  Between at(double t) noexcept {
    while (next_ + 1 < keys_.size() && keys_[next_].time <= t) ++next_;
    const Key& a = keys_[next_ - 1];
    const Key& b = keys_[next_];
    const double span = b.time - a.time;
    return {a, b, span > 0.0 ? std::clamp((t - a.time) / span, 0.0, 1.0) : 1.0};
  }
  double duration() const { return keys_.back().time; }
  std::string_view phase(double t) const {
    const auto after = std::upper_bound(keys_.begin(), keys_.end(), t,
                                        [](double time, const Key& k) { return time < k.time; });
    return after == keys_.begin() ? keys_.front().phase : (after - 1)->phase;
  }

 private:
  std::vector<Key> keys_;
  std::size_t next_ = 1;
};

}  // namespace onggi::script
