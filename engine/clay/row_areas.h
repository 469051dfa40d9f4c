#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "engine/clay/row_places.h"
#include "engine/clay/row_set.h"

namespace onggi {

/// The area of every row's cross-section (m^2), kept up to date by each press for effects that need
/// the loss; also which rows changed since they were last taken, and which are torn. A Clay has one
/// only if an effect asked for it: Clay::keep_areas(). Not safe across threads.
class RowAreas {
 public:
  RowAreas(int rows, int stride)
      : area_(static_cast<std::size_t>(rows)),
        cut_(area_.size()),
        given_(area_.size()),
        traded_(area_.size()),
        changed_(rows),
        unknown_(rows),
        spare_(static_cast<std::size_t>(stride)) {}

  /// Right to a float's digits of the changes since the last set(). Only where known(j).
  double of(int j) const { return area_[static_cast<std::size_t>(j)]; }
  bool known(int j) const { return !unknown_.has(j); }

  /// Sets row `j` to a measured area.
  void set(int j, double area) {
    area_[static_cast<std::size_t>(j)] = area;
    traded_[static_cast<std::size_t>(j)] = 0.0;
    unknown_.remove(j);
  }
  /// A press took this from row `j`; negative: it gave. `cut`: the clay leaves the pot.
  void lose(int j, double area, bool cut = false) {
    area_[static_cast<std::size_t>(j)] -= area;
    traded_[static_cast<std::size_t>(j)] += area < 0.0 ? -area : area;
    if (cut) cut_[static_cast<std::size_t>(j)] += area;
    changed_.add(j);
  }
  /// Row `j`, which something else made lower or smaller, lost this for good: of its cross-section,
  /// at the thickness that it has now.
  void cut_off(int j, double area) {
    cut_[static_cast<std::size_t>(j)] += area;
    changed_.add(j);
  }
  /// Row `j` lost and gained so much since it was measured that float sums may be off: a quarter of
  /// its area, for a tenth of a millionth.
  bool drifted(int j) const {
    return traded_[static_cast<std::size_t>(j)] > 0.25 * area_[static_cast<std::size_t>(j)];
  }
  /// Row `j` gained this area from other rows (negative: gave), with its volume.
  void trade(int j, double area) {
    area_[static_cast<std::size_t>(j)] += area;
    keep_for(j, -area);
  }
  /// Area that row `j` gives away without a receiver, m^2.
  void keep_for(int j, double area) {
    given_[static_cast<std::size_t>(j)] += area;
    changed_.add(j);
  }
  /// Takes what row `j` gives by trade() and keep_for() together, m^2, since it was last taken;
  /// negative: it gains.
  double take_given(int j) { return std::exchange(given_[static_cast<std::size_t>(j)], 0.0); }
  /// Takes the area cut from row `j`, m^2, since it was last taken.
  double take_cut(int j) { return std::exchange(cut_[static_cast<std::size_t>(j)], 0.0); }
  /// True if row `j` is marked.
  bool changed(int j) const { return changed_.has(j); }
  /// A row of unknown area is inserted at place `j`, or the one there is removed.
  void open(int j) {
    clay::open_place(area_, j);
    clay::open_place(cut_, j);
    clay::open_place(given_, j);
    clay::open_place(traded_, j);
    for (RowSet* rows : {&changed_, &unknown_}) rows->open(j);
    if (torn_.room() > 0) torn_.open(j);
    if (firm_.room() > 0) firm_.open(j), rigid_.open(j);
  }
  void close(int j) {
    clay::close_place(area_, j);
    clay::close_place(cut_, j);
    clay::close_place(given_, j);
    clay::close_place(traded_, j);
    for (RowSet* rows : {&changed_, &unknown_}) rows->close(j);
    if (torn_.room() > 0) torn_.close(j);
    if (firm_.room() > 0) firm_.close(j), rigid_.close(j);
  }
  /// Row `j` became thinner or thicker.
  void mark(int j) { changed_.add(j); }
  /// Row `j` was written, so it must be measured.
  void forget(int j) {
    changed_.add(j);
    unknown_.add(j);
  }
  /// Adds the rows marked since they were last taken to `rows`. `taken`: clears the marks.
  void add_changed(RowSet& rows, bool taken) {
    rows.add(changed_);
    if (taken) changed_.clear();
  }
  /// Allows rows to tear from now on. Allocates.
  void keep_torn() { torn_ = RowSet(changed_.room()); }
  /// Row `j` is torn: tools pass through. O(1), and mend() O(rows / 64).
  void tear(int j) {
    torn_.add(j);
    any_torn_ = true;
  }
  void mend() {
    torn_.clear();
    any_torn_ = false;
  }
  bool any_torn() const { return any_torn_; }
  bool torn(int j) const { return any_torn_ && torn_.has(j); }
  /// Allows rows to be firm from now on. Allocates.
  void keep_firm() { firm_ = rigid_ = RowSet(changed_.room()); }
  /// Row `j`, or every row, may not get higher. Firm: a pressed wall moves as a whole, and a row
  /// without an inner face does not give way. Rigid (firm too): nothing gives way.
  void harden(int j, bool firm, bool rigid) {
    if (any_firm_) firm_.remove(j), rigid_.remove(j);
    if (firm) firm_.add(j), any_firm_ = true;
    if (rigid) rigid_.add(j);
  }
  void harden_all(bool firm, bool rigid) { all_firm_ = firm, all_rigid_ = rigid; }
  void soften() {
    firm_.clear(), rigid_.clear();
    any_firm_ = all_firm_ = all_rigid_ = false;
  }
  bool any_firm() const { return any_firm_ || all_firm_; }
  bool firm(int j) const { return all_firm_ || (any_firm_ && firm_.has(j)); }
  bool rigid(int j) const { return all_rigid_ || (any_firm_ && rigid_.has(j)); }
  /// Scratch row for writers when nobody asked.
  float* spare_row() { return spare_.data(); }
  /// Takes and clears the lowest changed row at or above `from`; -1 when none is left.
  int take_changed(int from) { return changed_.take(from); }

 private:
  std::vector<double> area_, cut_, given_;
  std::vector<double> traded_;  // m^2 lost or gained since measured
  RowSet changed_, unknown_;
  RowSet torn_;  // empty if no row can tear
  bool any_torn_ = false;
  RowSet firm_, rigid_;  // empty if no row can be firm
  bool any_firm_ = false, all_firm_ = false, all_rigid_ = false;
  std::vector<float> spare_;
};

}  // namespace onggi
