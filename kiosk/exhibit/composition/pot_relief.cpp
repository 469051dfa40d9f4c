#include "kiosk/exhibit/composition/pot_relief.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "kiosk/collection/decoration/relief.h"

namespace onggi::exhibit {

namespace {

constexpr std::size_t kPlacesOfBlock = souvenir::ReliefModel::kFine;
constexpr double kMicrons = 1e6;

/// A ring of the body at even angles, as large as it is printed.
struct Ring {
  std::vector<Vec2> at;  ///< Distance from the axis, and height, m.
  Vec2 mean;
  double down = 0.0;  ///< In the unrolled picture.
  double way = 0.0;   ///< Along the outline, from the foot's edge, m.
  Vec2 faces;         ///< Of unit length.
  bool ends = false;  ///< A face of the clay ends here.
  bool on_lip = false;
};

double share_between(double from, double to, double at) {
  return to > from ? std::clamp((at - from) / (to - from), 0.0, 1.0) : 0.0;
}

/// The rings of `body`, from the foot's edge to where the surface ends.
class Body {
 public:
  Body(const ClayMesh& body, const std::vector<std::array<float, 2>>& places, double size)
      : body_(body), places_(places), size_(size) {
    sectors_ = static_cast<std::size_t>(std::ranges::count(body.faces, ClayFace::foot)) / 2;
    for (std::size_t first = 2 * sectors_; first + sectors_ <= body.faces.size(); first += sectors_)
      add(first);
    end_floor();
    measure();
  }
  const std::vector<Ring>& rings() const { return rings_; }
  std::size_t corners() const { return sectors_; }

 private:
  void add(std::size_t first) {
    const ClayFace face = body_.faces[first];
    Ring ring;
    // By angle: sectors of an odd number are unequal.
    std::vector<std::pair<double, Vec2>> around;
    for (std::size_t n = first; n < first + sectors_; ++n) {
      const auto& [x, y, z] = body_.mesh.positions[n];
      around.emplace_back(double{places_[n][0]},
                          Vec2{size_ * std::hypot(double{x}, double{z}), size_ * double{y}});
      ring.down += double{places_[n][1]} / static_cast<double>(sectors_);
    }
    std::ranges::sort(around, {}, &std::pair<double, Vec2>::first);
    for (std::size_t n = 0; n < sectors_; ++n) {
      const double turn = static_cast<double>(n) / static_cast<double>(sectors_);
      const auto after =
          std::ranges::lower_bound(around, turn, {}, &std::pair<double, Vec2>::first);
      const bool none_after = after == around.end(), none_before = after == around.begin();
      const auto& b = none_after ? around.front() : *after;
      const auto& a = none_before ? around.back() : *(after - 1);
      const double from = a.first - (none_before ? 1.0 : 0.0),
                   to = b.first + (none_after ? 1.0 : 0.0);
      const double part = share_between(from, to, turn);
      ring.at.push_back((1.0 - part) * a.second + part * b.second);
      ring.mean = ring.mean + (1.0 / static_cast<double>(sectors_)) * ring.at.back();
    }
    ring.on_lip = face == ClayFace::rim;
    if (!rings_.empty() && length(ring.mean - rings_.back().mean) < 1e-7) {
      // The last ring of a face is the next one's first.
      rings_.back().ends = rings_.back().ends || face != last_;
      last_ = face;
      return;
    }
    ring.ends = rings_.empty();
    if (!rings_.empty()) ring.down = std::max(ring.down, rings_.back().down);
    last_ = face;
    rings_.push_back(std::move(ring));
  }

  /// The last ring lies on the axis; the surface ends before it.
  void end_floor() {
    Ring axis = std::move(rings_.back());
    rings_.pop_back();
    Ring& wall = rings_.back();
    wall.ends = true;
    const double least = size_ * surface::kLeastRadius;
    if (wall.mean.x <= 1.05 * least) return;
    Ring end = wall;
    const double part = (wall.mean.x - least) / (wall.mean.x - axis.mean.x);
    end.mean = (1.0 - part) * wall.mean + part * axis.mean;
    for (std::size_t n = 0; n < sectors_; ++n)
      end.at[n] = (1.0 - part) * wall.at[n] + part * axis.at[n];
    end.down = 1.0;
    rings_.push_back(std::move(end));
  }

  void measure() {
    const auto across = [this](std::size_t a, std::size_t b) {
      const Vec2 way = rings_[b].mean - rings_[a].mean;
      const double size = length(way);
      return size > 0.0 ? Vec2{way.y / size, -way.x / size} : Vec2{0.0, 0.0};
    };
    for (std::size_t k = 0; k < rings_.size(); ++k) {
      if (k > 0) rings_[k].way = rings_[k - 1].way + length(rings_[k].mean - rings_[k - 1].mean);
      Vec2 sum;
      if (k > 0) sum = sum + across(k - 1, k);
      if (k + 1 < rings_.size()) sum = sum + across(k, k + 1);
      const double size = length(sum);
      rings_[k].faces = size > 1e-9 ? (1.0 / size) * sum : Vec2{1.0, 0.0};
    }
  }

  const ClayMesh& body_;
  const std::vector<std::array<float, 2>>& places_;
  double size_;
  std::size_t sectors_ = 0;
  ClayFace last_ = ClayFace::foot;
  std::vector<Ring> rings_;
};

/// A row of the grid before the even ones are left out.
struct GridRow {
  souvenir::ReliefModel::Row row;
  bool kept = false;  ///< A face ends here, or it lies on the lip, where the body bends most.
};

class Grid {
 public:
  Grid(const Body& body, const surface::Surface& surface, double size) : body_(body) {
    double widest = 0.0;
    for (const Ring& ring : body.rings()) widest = std::max(widest, ring.mean.x);
    const double round = 2.0 * std::numbers::pi * widest / kReliefGrid / kPlacesOfBlock;
    blocks_ = static_cast<std::size_t>(
        std::clamp(std::ceil(round), 2.0, static_cast<double>(souvenir::ReliefModel::kMostBlocks)));
    const std::vector<Ring>& rings = body.rings();
    for (std::size_t from = 0; from + 1 < rings.size();) {
      std::size_t to = from + 1;
      while (to + 1 < rings.size() && !rings[to].ends) ++to;
      const double way = rings[to].way - rings[from].way;
      const int steps = std::max(1, static_cast<int>(std::ceil(way / kReliefGrid)));
      for (int n = from == 0 ? 0 : 1; n <= steps; ++n)
        add(rings[from].way + way * n / steps, n == 0 || n == steps, surface, size);
      from = to;
    }
    find_fine();
  }

  std::vector<souvenir::ReliefModel::Row> kept_rows() {
    std::vector<souvenir::ReliefModel::Row> out;
    std::size_t at = 0;
    while (true) {
      out.push_back(std::move(rows_[at].row));
      if (at + 1 == rows_.size()) return out;
      std::size_t next = at + 1;
      for (const std::size_t far : {8u, 4u, 2u})
        if (at + far < rows_.size() && even_between(out.back(), at, at + far)) {
          next = at + far;
          break;
        }
      if (next > at + 1) out.back().fine.assign(blocks_, false);
      at = next;
    }
  }
  int blocks() const { return static_cast<int>(blocks_); }

 private:
  void add(double way, bool kept, const surface::Surface& surface, double size) {
    const std::vector<Ring>& rings = body_.rings();
    while (ring_ + 2 < rings.size() && rings[ring_ + 1].way < way - 1e-12) ++ring_;
    const Ring &a = rings[ring_], &b = rings[ring_ + 1];
    const double part = share_between(a.way, b.way, way);
    GridRow grid;
    grid.kept = kept || a.on_lip || b.on_lip;
    Vec2 faces = (1.0 - part) * a.faces + part * b.faces;
    faces = (1.0 / std::max(length(faces), 1e-9)) * faces;
    grid.row.out = static_cast<float>(faces.x), grid.row.up = static_cast<float>(faces.y);
    for (std::size_t n = 0; n < body_.corners(); ++n) {
      const Vec2 at = (1.0 - part) * a.at[n] + part * b.at[n];
      grid.row.body.push_back({static_cast<float>(at.x), static_cast<float>(at.y)});
    }
    const double down = std::lerp(a.down, b.down, part);
    const std::size_t places = kPlacesOfBlock * blocks_;
    for (std::size_t n = 0; n < places; ++n) {
      const double turn = static_cast<double>(n) / static_cast<double>(places);
      grid.row.heights.push_back(static_cast<std::int16_t>(
          std::lround(kMicrons * size * decoration::height_at(surface, turn, down))));
    }
    rows_.push_back(std::move(grid));
  }

  /// The height of a block's corner, which may be the next one's.
  double corner(const souvenir::ReliefModel::Row& row, std::size_t block) const {
    return row.heights[block % blocks_ * kPlacesOfBlock];
  }

  void find_fine() {
    constexpr double kEven = kMicrons * kReliefEven;
    std::vector<bool> before(blocks_);  // of the row below
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const auto& row = rows_[r].row;
      std::vector<bool> bends(blocks_);
      for (std::size_t b = 0; b < blocks_; ++b)
        for (std::size_t k = 1; k < kPlacesOfBlock; ++k) {
          const double straight = std::lerp(corner(row, b), corner(row, b + 1),
                                            static_cast<double>(k) / kPlacesOfBlock);
          if (std::abs(row.heights[b * kPlacesOfBlock + k] - straight) > kEven) bends[b] = true;
        }
      rows_[r].row.fine.assign(blocks_, false);
      if (r > 0)
        for (std::size_t b = 0; b < blocks_; ++b) rows_[r - 1].row.fine[b] = bends[b] || before[b];
      before = std::move(bends);
    }
  }

  /// The rows between `from` (moved to `first`) and `to` lie straight between them, and no place of
  /// theirs is needed.
  bool even_between(const souvenir::ReliefModel::Row& first, std::size_t from,
                    std::size_t to) const {
    constexpr double kEven = kMicrons * kReliefEven;
    for (std::size_t r = from; r < to; ++r) {
      const auto& row = r == from ? first : rows_[r].row;
      if (r > from && rows_[r].kept) return false;
      for (std::size_t b = 0; b < blocks_; ++b) {
        if (row.fine[b]) return false;
        const double straight =
            std::lerp(corner(first, b), corner(rows_[to].row, b),
                      static_cast<double>(r - from) / static_cast<double>(to - from));
        if (std::abs(corner(row, b) - straight) > kEven) return false;
      }
    }
    return true;
  }

  const Body& body_;
  std::size_t blocks_ = 2, ring_ = 0;
  std::vector<GridRow> rows_;
};

}  // namespace

souvenir::ReliefModel relief_of(const ClayMesh& body,
                                const std::vector<std::array<float, 2>>& places,
                                const surface::Surface& surface, double size,
                                const std::string& title) {
  const Body rings(body, places, size);
  Grid grid(rings, surface, size);
  souvenir::ReliefModel model;
  model.title = title;
  model.blocks = grid.blocks();
  model.rows = grid.kept_rows();
  return model;
}

bool raise(decoration::Skin& skin, const surface::Surface& surface, double size, double share,
           double wide, double high) {
  struct Move {
    std::array<double, 3> faces{};  ///< The sum of the normals there.
    double height = 0.0;
    bool told = false;
  };
  // Faces that meet in an edge have positions there of their own.
  std::map<std::array<float, 3>, Move> moves;
  double most = 0.0;
  for (std::size_t n = 0; n < skin.mesh.positions.size(); ++n) {
    Move& move = moves[skin.mesh.positions[n]];
    for (std::size_t k = 0; k < 3; ++k) move.faces[k] += double{skin.mesh.normals[n][k]};
    if (std::exchange(move.told, true)) continue;
    move.height = size * share *
                  decoration::mean_height(surface, double{skin.places[n][0]},
                                          double{skin.places[n][1]}, wide, high);
    most = std::max(most, std::abs(move.height));
  }
  if (most < kReliefMoves) return false;
  for (auto& at : skin.mesh.positions) {
    const Move& move = moves.at(at);
    const double far = std::hypot(move.faces[0], move.faces[1], move.faces[2]);
    if (far < 1e-6) continue;
    std::array<float, 3> to = at;
    for (std::size_t k = 0; k < 3; ++k)
      to[k] += static_cast<float>(move.height * move.faces[k] / far);
    to[1] = std::max(to[1], 0.0f);  // it stands as before
    at = to;
  }
  return true;
}

}  // namespace onggi::exhibit
