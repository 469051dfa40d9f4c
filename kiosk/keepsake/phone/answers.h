#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "engine/base/result.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/web/message.h"
#include "kiosk/keepsake/phone/phone_words.h"
#include "kiosk/keepsake/souvenir/open_passes.h"

namespace onggi::phone {

/// The visitor's page and its files:
///   GET  /k/TOKEN               the page: postcard, turning pot, downloads, delete; in the
///                               visit's language, or that of ?lang=CODE
///   GET  /k/TOKEN/postcard.jpg, turning.gif, rollout.jpg, sheet.jpg, pot.glb, pot.stl
///                               whole, or one span of bytes
///   POST /k/TOKEN/delete        removes every copy at once
///   GET  /page.js, .css, .svg   the same for everybody
///   GET  /generate_204 ...      network checks of phones (probes.h)
/// HEAD is answered like GET; whoever sends the answer leaves out its content. All other requests,
/// also with a wrong, expired or deleted token, get the same answer. Uses no socket. One thread.
class Answers final : public web::Answering {
 public:
  /// `clock` gives s since 1970. `tell` gets what the staff should know of a file, once each.
  Answers(souvenir::OpenPasses passes, std::function<std::int64_t()> clock,
          PhoneLanguages languages = {},
          std::function<void(const Problem&)> tell = files::log_problem)
      : passes_(std::move(passes)),
        clock_(std::move(clock)),
        languages_(std::move(languages)),
        tell_(std::move(tell)) {}

  web::Answer to(const web::Ask& ask) override;
  /// Call it at least once a minute, and again while it returns true: records that the server runs,
  /// and removes expired passes, a few in each call.
  bool look_after() {
    passes_.serve();
    return passes_.forget_some(clock_());
  }
  void end() const { passes_.end_serving(); }

 private:
  web::Answer nothing_here(const web::Ask& ask) const;
  void tell_once(const Problem& remark);

  souvenir::OpenPasses passes_;
  std::function<std::int64_t()> clock_;
  PhoneLanguages languages_;
  std::function<void(const Problem&)> tell_;
  std::set<std::string> told_;  // by text
};

}  // namespace onggi::phone
