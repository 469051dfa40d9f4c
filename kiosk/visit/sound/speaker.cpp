#include "kiosk/visit/sound/speaker.h"

#include <SDL2/SDL.h>
#include <alsa/asoundlib.h>
#include <pthread.h>
#include <sched.h>

#include <span>
#include <utility>

#include "kiosk/ground/files/monotonic.h"

namespace onggi::sound {

namespace {

// Without a card ALSA writes a screenful to standard error; SDL reports it in a line.
void discard_message(const char*, int, const char*, int, const char*, ...) {}

/// Below the 1 kHz loop, which shares a core with it. Above the drawing, because a block is due
/// every 8 ms. SDL's own way needs a desktop service that a kiosk lacks.
void raise_priority() noexcept {
  sched_param parameter{};
  parameter.sched_priority = Speaker::kPriority;
  pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameter);
}

constexpr auto kBlockNs = static_cast<std::int64_t>(Speaker::kBlock / kRate * 1e9);

}  // namespace

Speaker::Speaker(std::function<Heard()> listen) : listen_(std::move(listen)) {
  // Keep the kiosk's own signal handlers.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  snd_lib_error_set_handler(&discard_message);
  SDL_SetHint(SDL_HINT_AUDIO_DEVICE_APP_NAME, "Onggi");
  open();
}

Speaker::~Speaker() {
  close();
  if (sdl_) SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

void Speaker::open() {
  std::string fault;
  sdl_ = sdl_ || SDL_InitSubSystem(SDL_INIT_AUDIO) == 0;
  if (sdl_) {
    SDL_AudioSpec wanted{}, got{};
    wanted.freq = static_cast<int>(kRate);
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 1;
    wanted.samples = kBlock;
    wanted.callback = &Speaker::asked;
    wanted.userdata = this;
    // SDL converts to other rates and channels.
    device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &got, 0);
  }
  if (device_ == 0) fault = SDL_GetError();
  const std::string line =
      device_ != 0 ? std::string("Sound is played by ") + SDL_GetCurrentAudioDriver() + "."
                   : "There is no sound (" + fault + "); play goes on without it.";
  if (line != said_) said_ = remark_ = line;
  if (device_ == 0) return;
  asked_ns_ = 0;
  SDL_PauseAudioDevice(device_, 0);
}

void Speaker::close() {
  if (device_ != 0) SDL_CloseAudioDevice(std::exchange(device_, 0u));
}

void Speaker::look(double now) {
  // A removed card stops; SDL keeps its name until it is closed.
  if (device_ != 0 && SDL_GetAudioDeviceStatus(device_) == SDL_AUDIO_STOPPED) close();
  if (device_ != 0 || now - looked_ < kLookAgain) return;
  looked_ = now;
  open();
}

void Speaker::sing(const OutlineSong& song) {
  const unsigned next = sung_.load(std::memory_order_relaxed) + 1;
  songs_[next % songs_.size()] = song;
  sung_.store(next, std::memory_order_release);
}

std::string Speaker::remark() { return std::exchange(remark_, {}); }

Speaker::Status Speaker::status() const {
  return {blocks_.load(), late_.load(), static_cast<double>(worst_gap_ns_.load()) * 1e-9,
          touches_.load(), touched_ns_.load()};
}

void Speaker::asked(void* self, unsigned char* out, int bytes) noexcept {
  static_cast<Speaker*>(self)->play(reinterpret_cast<float*>(out),
                                    bytes / static_cast<int>(sizeof(float)));
}

void Speaker::play(float* out, int samples) noexcept {
  const std::int64_t now = files::monotonic_ns();
  if (const std::int64_t before = std::exchange(asked_ns_, now); before != 0) {
    const std::int64_t gap = now - before;
    // SDL holds one block in reserve, so a delay of one block is not heard.
    if (gap > 2 * kBlockNs) late_.fetch_add(1, std::memory_order_relaxed);
    if (gap > worst_gap_ns_.load(std::memory_order_relaxed))
      worst_gap_ns_.store(gap, std::memory_order_relaxed);
  } else {
    raise_priority();
  }
  Heard heard = listen_();
  heard.volume = volume_.load(std::memory_order_relaxed);
  heard.fire = fire_.load(std::memory_order_relaxed);
  if (const double push = rub_push_.load(std::memory_order_relaxed); push > 0.0)
    heard.rub[0] = {static_cast<Rub::Kind>(rubbed_.load(std::memory_order_relaxed)),
                    rub_slip_.load(std::memory_order_relaxed), push};
  bool rubs = false;
  for (const Rub& rub : heard.rub) rubs = rubs || rub.push > 0.0;
  if (rubs && !std::exchange(rubs_, rubs)) {
    touched_ns_.store(now + kBlockNs, std::memory_order_relaxed);
    touches_.fetch_add(1, std::memory_order_release);
  }
  rubs_ = rubs;
  if (const unsigned newest = sung_.load(std::memory_order_acquire); newest != heard_song_) {
    heard_song_ = newest;
    synthesis_.sing(songs_[newest % songs_.size()]);
  }
  synthesis_.play(heard, std::span(out, static_cast<std::size_t>(samples)));
  blocks_.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace onggi::sound
