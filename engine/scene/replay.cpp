#include "engine/scene/replay.h"

#include <array>
#include <bit>
#include <type_traits>

#include "engine/scene/replay_bytes.h"
#include "engine/scene/replay_scene.h"

namespace onggi {
namespace {

using namespace replay_bytes;

constexpr std::size_t kMostTicks = 4'000'000;  // over an hour; a visit is minutes
constexpr std::size_t kLongestId = 4096;

// The first hand's bits of switches that came later than the others.
constexpr unsigned kCoils = 3 * (kMaxHands + 1), kPaddles = kCoils + kMaxHands,
                   kBlows = kPaddles + kMaxHands, kFire = kBlows + kMaxHands;
static_assert(kFire == 15, "the last of 16 bits");

// All switches in 16 bits: three per hand, three for the potter, then coil, paddle, blow and fire.
// Before kFirstSwings the coil's bit of a hand with a paddle said whether there is an anvil.
std::uint16_t switches_of(const Hands& hands) {
  unsigned bits = 0;
  for (const HandInput& hand : hands.hand)
    bits = bits << 3 | static_cast<unsigned>(hand.side) << 1 | static_cast<unsigned>(hand.active);
  bits =
      bits << 3 | unsigned{hands.water} << 2 | unsigned{hands.renew} << 1 | unsigned{hands.restore};
  for (std::size_t n = 0; n < hands.hand.size(); ++n)
    bits |= unsigned{hands.hand[n].coil} << (kCoils + n) |
            unsigned{hands.hand[n].paddle} << (kPaddles + n) |
            unsigned{hands.hand[n].blow} << (kBlows + n);
  bits |= unsigned{hands.fire} << kFire;
  return static_cast<std::uint16_t>(bits);
}

bool put_switches(Hands& hands, std::uint16_t bits) {
  for (std::size_t n = 0; n < hands.hand.size(); ++n) {
    HandInput& hand = hands.hand[n];
    hand.coil = (bits >> (kCoils + n) & 1u) != 0;
    hand.paddle = (bits >> (kPaddles + n) & 1u) != 0;
    hand.blow = (bits >> (kBlows + n) & 1u) != 0;
  }
  hands.restore = (bits & 1u) != 0;
  hands.renew = (bits & 2u) != 0;
  hands.water = (bits & 4u) != 0;
  hands.fire = (bits >> kFire & 1u) != 0;
  for (std::size_t n = kMaxHands; n-- > 0;) {
    bits = static_cast<std::uint16_t>(bits >> 3);
    const unsigned side = (bits >> 1) & 3u;
    if (side > static_cast<unsigned>(SideWish::inside)) return false;
    hands.hand[n].active = (bits & 1u) != 0;
    hands.hand[n].side = static_cast<SideWish>(side);
  }
  return true;
}

void give_anvils(Hands& hands) {
  for (HandInput& hand : hands.hand) {
    hand.anvil = hand.paddle && hand.coil ? 1.0 : 0.0;
    hand.coil = hand.coil && !hand.paddle;
  }
}

// Compares bits, so that NaN equals itself and -0 differs from 0.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same(Vec3 a, Vec3 b) { return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z); }

bool same_swings(const Hands& a, const Hands& b) {
  for (std::size_t n = 0; n < a.hand.size(); ++n)
    if (!same(a.hand[n].swing, b.hand[n].swing) || !same(a.hand[n].anvil, b.hand[n].anvil))
      return false;
  return true;
}

bool same_hold(const HandInput& a, const HandInput& b) {
  return a.tool == b.tool && same(a.handle, b.handle) && same(a.roll, b.roll);
}

// Calls `io` with each value of the fields that `fields` names, and its column, for both writing
// and reading.
template <class Io>
bool tick_fields(Io&& io, std::uint8_t fields, TickRecord& r) {
  const auto vec = [&](Vec3& v, std::size_t column) {
    return io(v.x, column) && io(v.y, column + 1) && io(v.z, column + 2);
  };
  const auto hold = [&](std::size_t hand, std::size_t column) {
    HandInput& held = r.hands.hand[hand];
    return io(held.tool, hand) && vec(held.handle, column) && io(held.roll, column + 3);
  };
  std::uint16_t switches = switches_of(r.hands);
  bool good = true;
  if ((fields & kHand0) != 0) good = vec(r.hands.hand[0].position, 0);
  if ((fields & kHand1) != 0) good = good && vec(r.hands.hand[1].position, 3);
  if ((fields & kSwitches) != 0) good = good && io(switches, 0) && put_switches(r.hands, switches);
  if ((fields & kWheel) != 0) good = good && io(r.hands.wheel_speed, 6);
  if ((fields & kTime) != 0) good = good && io(r.dt, 7);
  if ((fields & kHold0) != 0) good = good && hold(0, 8);
  if ((fields & kHold1) != 0) good = good && hold(1, 12);
  for (std::size_t n = 0; (fields & kSwings) != 0 && n < r.hands.hand.size(); ++n)
    good = good && io(r.hands.hand[n].swing, 16 + 2 * n) && io(r.hands.hand[n].anvil, 17 + 2 * n);
  return good;
}

// Takes values out of columns, as tick_fields() asks.
class ColumnFeed {
 public:
  explicit ColumnFeed(const Columns& columns) : columns_(columns) {}
  bool operator()(double& v, std::size_t n) {
    v = std::bit_cast<double>(columns_.numbers[n][numbers_[n]++]);
    return true;
  }
  bool operator()(std::uint8_t& tool, std::size_t n) {
    tool = columns_.tools[n][tools_[n]++];
    return true;
  }
  bool operator()(std::uint16_t& switches, std::size_t) {
    switches = columns_.switches[switches_++];
    return true;
  }

 private:
  const Columns& columns_;
  std::array<std::size_t, kNumbers> numbers_{};
  std::array<std::size_t, kMaxHands> tools_{};
  std::size_t switches_ = 0;
};

constexpr const char* kBadTick = "A tick is damaged or cut short.";
constexpr const char* kTooLong = "The replay is longer than an hour.";

// What follows the beginning of a replay of `version`. Null, or what is wrong.
const char* read_columns_of(Reader& io, std::uint32_t version, Replay& replay) {
  std::uint32_t notes = 0;
  if (!io.text(replay.glaze, kLongestId) || !io(replay.final_hash) || !io(notes))
    return "The replay's beginning is cut short or damaged.";
  for (std::uint32_t n = 0; n < notes; ++n) {
    Note note;
    if (!io(note.tick) || !io(note.hash)) return "The replay is cut short within a hash.";
    if (!replay.notes.empty() && note.tick < replay.notes.back().tick)
      return "The replay's hashes are not in order.";
    replay.notes.push_back(note);
  }
  Columns columns;
  if (!read_columns(io, version, columns)) return kBadTick;
  if (columns.fields.size() > kMostTicks) return kTooLong;
  if (io.left() != 0) return "The replay's end is damaged.";
  if (!replay.notes.empty() && replay.notes.back().tick > columns.fields.size())
    return "A hash is noted behind the last tick.";
  TickRecord last;
  ColumnFeed feed(columns);
  replay.ticks.reserve(columns.fields.size());
  for (const std::uint8_t fields : columns.fields) {
    if (!tick_fields(feed, fields, last)) return kBadTick;
    replay.ticks.push_back(last);
    if (version < kFirstSwings) give_anvils(replay.ticks.back().hands);
  }
  return nullptr;
}

// Likewise, of a version before kFirstColumns.
const char* read_rows_of(Reader& io, Replay& replay) {
  TickRecord last;
  const auto take = [&io](auto& value, std::size_t) { return io(value); };
  for (;;) {
    std::uint8_t tag = 0;
    if (!io(tag)) return "The replay is cut short: it has no end.";
    if (tag == kEnd) {
      if (!io(replay.final_hash) || io.left() != 0) return "The replay's end is damaged.";
      return nullptr;
    }
    if (tag == kNote) {
      Note note{replay.ticks.size(), 0};
      if (!io(note.hash)) return "The replay is cut short within a hash.";
      replay.notes.push_back(note);
      continue;
    }
    if (tag == kGlaze) {
      if (!io.text(replay.glaze, kLongestId)) return "The replay is cut short in a name.";
      continue;
    }
    if ((tag & ~unsigned{kFieldsBefore}) != 0 || !tick_fields(take, tag, last)) return kBadTick;
    if (replay.ticks.size() == kMostTicks) return kTooLong;
    replay.ticks.push_back(last);
  }
}

}  // namespace

ReplayWriter::ReplayWriter(const SceneDef& def, const std::string& vessel_id, std::uint64_t seed) {
  Writer io(head_);
  std::uint64_t magic = kMagic;
  std::uint32_t version = kVersion;
  io(magic);
  io(version);
  write_scene(io, def);
  io(seed);
  io.text(vessel_id, kLongestId);
}

void ReplayWriter::tick(const TickRecord& record) {
  unsigned fields = 0;
  const Hands& now = record.hands;
  const Hands& then = last_.hands;
  if (!same(now.hand[0].position, then.hand[0].position)) fields |= kHand0;
  if (!same(now.hand[1].position, then.hand[1].position)) fields |= kHand1;
  if (switches_of(now) != switches_of(then)) fields |= kSwitches;
  if (!same(now.wheel_speed, then.wheel_speed)) fields |= kWheel;
  if (!same(record.dt, last_.dt)) fields |= kTime;
  if (!same_hold(now.hand[0], then.hand[0])) fields |= kHold0;
  if (!same_hold(now.hand[1], then.hand[1])) fields |= kHold1;
  if (!same_swings(now, then)) fields |= kSwings;
  last_ = record;
  columns_.fields.push_back(static_cast<std::uint8_t>(fields));
  const auto keep = [this]<class Value>(const Value& value, std::size_t n) {
    if constexpr (std::is_same_v<Value, double>)
      columns_.numbers[n].push_back(std::bit_cast<std::uint64_t>(value));
    else if constexpr (std::is_same_v<Value, std::uint8_t>)
      columns_.tools[n].push_back(value);
    else
      columns_.switches.push_back(value);
    return true;
  };
  tick_fields(keep, columns_.fields.back(), last_);
}

bool ReplayWriter::full() const { return columns_.fields.size() >= kMostTicks; }

void ReplayWriter::note_hash(std::uint64_t state_hash) {
  notes_.push_back({columns_.fields.size(), state_hash});
}

std::vector<std::byte> ReplayWriter::finish(std::uint64_t state_hash,
                                            const std::string& glaze) const {
  std::vector<std::byte> bytes = head_;
  Writer io(bytes);
  io.text(glaze, kLongestId);
  io(state_hash);
  auto notes = static_cast<std::uint32_t>(notes_.size());
  io(notes);
  for (Note note : notes_) {
    io(note.tick);
    io(note.hash);
  }
  write_columns(io, columns_);
  seal(bytes);
  return bytes;
}

Result<Replay> Replay::read(std::span<const std::byte> bytes, const std::string& name) {
  // A flipped byte among the ticks reads as another visit; only the checksum detects it.
  const std::span<const std::byte> body = unsealed(bytes);
  Reader io(body.empty() ? bytes : body);
  const auto malformed = [&](const char* what) {
    return problem(name + ", byte " + std::to_string(io.at()), what,
                   "Use a replay file that this program wrote, whole.");
  };
  std::uint64_t magic = 0;
  std::uint32_t version = 0;
  if (!io(magic) || magic != kMagic) return malformed("This is no replay.");
  if (!io(version) || version < kOldestVersion || version > kVersion)
    return malformed("The replay was written by another version of the engine, or is damaged.");
  if (body.empty())
    return malformed("The replay is damaged or cut short: its checksum is of other bytes.");
  Replay replay;
  std::string unknown;
  const bool read = read_scene(io, version, replay.def, unknown);
  if (!unknown.empty())
    return problem(name + ", " + unknown, "This engine does not know \"" + unknown + "\".",
                   "Replay it with the version of this program that wrote it, or a later one.");
  if (!read || !io(replay.seed) || !io.text(replay.vessel_id, kLongestId))
    return malformed("The replay's beginning is cut short or damaged.");
  if (auto good = validate(replay.def); !good)
    return problem(name + ", " + good.error().where, good.error().what,
                   "The file is damaged: use a replay that this program wrote.");
  replay.earlier_laws = version < kLaws || (version < kFirstSwings && replay.def.building);
  const char* const wrong =
      version < kFirstColumns ? read_rows_of(io, replay) : read_columns_of(io, version, replay);
  if (wrong != nullptr) return malformed(wrong);
  return replay;
}

Result<ReplayOutcome> run_replay(const Replay& replay, std::unique_ptr<Scene>* scene_out) {
  Result<Scene> scene = Scene::create(replay.def);
  if (!scene) return tl::unexpected<Problem>(scene.error());
  ReplayOutcome outcome;
  outcome.vessel_id = replay.vessel_id;
  outcome.glaze = replay.glaze;
  outcome.earlier_laws = replay.earlier_laws;
  outcome.seed = replay.seed;
  outcome.recorded_hash = replay.final_hash;

  auto note = replay.notes.begin();
  const auto check = [&](std::uint64_t hash) {
    ++outcome.hashes_checked;
    if (scene->state_hash() != hash && outcome.first_difference_tick < 0)
      outcome.first_difference_tick = static_cast<std::int64_t>(outcome.ticks);
  };
  const auto check_notes = [&] {
    for (; note != replay.notes.end() && note->tick == outcome.ticks; ++note) check(note->hash);
  };
  check_notes();
  for (const TickRecord& record : replay.ticks) {
    scene->step(record.hands, record.dt);
    ++outcome.ticks;
    check_notes();
  }
  check(replay.final_hash);
  outcome.replayed_hash = scene->state_hash();
  if (scene_out != nullptr) *scene_out = std::make_unique<Scene>(std::move(*scene));
  return outcome;
}

}  // namespace onggi
