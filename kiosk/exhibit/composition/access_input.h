#pragma once

#include <functional>
#include <optional>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/visit/access/access_mode.h"
#include "kiosk/visit/access/voice_link.h"

namespace onggi::exhibit {

/// Handles input and speech for blind and one-switch visitors: passes events through the assistant
/// to the visit, and its words to the voice. Main thread.
class AccessInput {
 public:
  using Heard = std::function<void(const access::Utterance&)>;
  /// `voice`: speak aloud if a visitor wants it; scripted visits do not.
  AccessInput(const settings::Exhibit& exhibit, bool voice);

  void input(const view::InputEvent& event, screens::Visit& visit, int width, int height,
             double now);
  /// Call once for each finished frame, before it is drawn.
  void frame(screens::Visit& visit, view::Frame& frame, double now);
  /// The controls that the one switch offers now, by id.
  const std::vector<std::string>& shown() const { return access_mode_.scan().shown(); }
  /// Same as AccessMode's.
  bool sings() { return access_mode_.sings(); }
  /// Sets a listener for the spoken words, with or without a voice.
  void listen(Heard heard) { heard_ = std::move(heard); }

 private:
  access::AccessMode access_mode_;
  std::optional<access::VoiceLink> voice_;
  Heard heard_;
  double diagonal_mm_;
};

}  // namespace onggi::exhibit
