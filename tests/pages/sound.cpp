#include "kiosk/ground/files/output.h"
#include "tests/pages/page_program.h"
#include "tests/pages/studio_film.h"

namespace onggi::pages {

namespace {

struct SoundArguments {
  files::Output wav{files::Output::Kind::wav}, plot{files::Output::Kind::picture};
};

Result<int> sound(const SoundArguments& arguments) {
  if (!arguments.wav.wanted() && !arguments.plot.wanted())
    return problem("onggi_page_sound", "No file is named.", "Use --wav FILE or --plot FILE.");
  const StudioFilm film = studio_film();
  if (auto good = arguments.wav.write(wav_of(film)); !good) return tl::unexpected(good.error());
  if (!arguments.plot.wanted()) return 0;
  return arguments.plot.write(draw_spectrogram(spectrogram_of(film), arguments.plot.where()))
      .map([] { return 0; });
}

}  // namespace
}  // namespace onggi::pages

int main(int argc, char** argv) {
  onggi::pages::SoundArguments a;
  return onggi::pages::run_page_program(
      {.name = "onggi_page_sound",
       .help = "Record and draw the studio's sounds",
       .examples = "Example: build/release/bin/onggi_page_sound --wav studio.wav --plot studio.png",
       .options = {{"--wav", &a.wav, "Write 17 s of all sounds into this WAV"},
                   {"--plot", &a.plot, "Draw them into this PNG or SVG: pitch over time"}},
       .run = [&a] { return onggi::pages::sound(a); }},
      argc, argv);
}
