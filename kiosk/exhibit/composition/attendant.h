#pragma once

#include <functional>
#include <optional>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/visit/access/assistant.h"
#include "kiosk/visit/access/voice_link.h"

namespace onggi::exhibit {

/// Who does not see the screen, or has one switch, is attended to here: events go to the visit
/// through the assistant, and what it says to the voice. Main thread.
class Attendant {
 public:
  using Heard = std::function<void(const access::Utterance&)>;
  /// `voice`: there is one, as long as a visitor wants it; a scripted visit has none.
  Attendant(const settings::Exhibit& exhibit, bool voice);

  void input(const view::InputEvent& event, screens::Visit& visit, int width, int height,
             double now);
  /// Once a frame that has been made, before it is drawn.
  void frame(screens::Visit& visit, view::Frame& frame, double now);
  /// What one switch stands on: ids of controls.
  const std::vector<std::string>& shown() const { return assistant_.scan().shown(); }
  /// As Assistant's.
  bool sings() { return assistant_.sings(); }
  /// Hears what is said, voice or not.
  void listen(Heard heard) { heard_ = std::move(heard); }

 private:
  access::Assistant assistant_;
  std::optional<access::VoiceLink> voice_;
  Heard heard_;
  double diagonal_mm_;
};

}  // namespace onggi::exhibit
