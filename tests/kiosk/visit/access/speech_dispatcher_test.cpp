#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "kiosk/ground/files/child_process.h"
#include "kiosk/visit/access/voice_link.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::access::speech_dispatcher_test {
namespace {

namespace fs = std::filesystem;

/// speech-dispatcher itself with a folder of its own, whose voice writes to a file what it is to
/// say, and espeak-ng's sound of it beside; no sound card is needed.
class Dispatcher : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"/usr/bin/speech-dispatcher", "/usr/bin/espeak-ng"})
      if (!fs::exists(program)) GTEST_SKIP() << program << " is not installed";
    fs::create_directory(folder_ / "modules");
    write("speechd.conf",
          "LogLevel 1\nAddModule \"written\" \"sd_generic\" \"written.conf\"\n"
          "DefaultModule written\nDefaultLanguage en\nAudioOutputMethod \"alsa\"\n"
          "AudioALSADevice \"null\"\n");
    write("modules/written.conf", "GenericExecuteSynth \"echo '$VOICE: $DATA' >> " +
                                      (folder_ / "said").string() + "; espeak-ng -v $VOICE -w " +
                                      (folder_ / "last.wav").string() +
                                      " '$DATA'\"\n"
                                      "GenericLanguage \"en\" \"en\" \"utf-8\"\n"
                                      "GenericLanguage \"ko\" \"ko\" \"utf-8\"\n"
                                      "AddVoice \"en\" \"MALE1\" \"en\"\n"
                                      "AddVoice \"ko\" \"MALE1\" \"ko\"\nDefaultVoice \"en\"\n");
    auto server = files::ChildProcess::start(
        "speech-dispatcher",
        {"-s", "-C", folder_.path().string(), "-L", folder_.path().string(), "-P",
         (folder_ / "pid").string(), "-S", (folder_ / "sock").string()},
        {});
    ASSERT_TRUE(server);
    server_.emplace(std::move(*server));
    for (int n = 0; n < 500 && !fs::exists(folder_ / "sock"); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (!fs::exists(folder_ / "sock"))
      GTEST_SKIP() << "speech-dispatcher does not start here: it has no sound output to open";
    setenv("SPEECHD_ADDRESS", ("unix_socket:" + (folder_ / "sock").string()).c_str(), 1);
  }
  void TearDown() override {
    unsetenv("SPEECHD_ADDRESS");
    if (server_) server_->end(SIGTERM, 5);
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
  }
  std::string said() const { return files::test::content(folder_ / "said"); }
  const files::test::ScratchFolder folder_;
  std::optional<files::ChildProcess> server_;
};

TEST_F(Dispatcher, SaysEnglishAndKoreanToTheirEndAndHasNoVoiceForWhatNobodySpeaks) {
  const fs::path helper = fs::read_symlink("/proc/self/exe").parent_path() / "onggi-speech";
  ASSERT_TRUE(fs::exists(helper));
  VoiceLink voice(helper.string());
  double now = 0;
  voice.begin(now);
  std::vector<std::uint64_t> ended;
  std::vector<std::string> remarks;
  const auto until = [&](auto&& so) {
    for (int n = 0; n < 1500 && !so(); ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      voice.look(now += 0.01);
      for (const auto id : voice.ended()) ended.push_back(id);
      for (auto& line : voice.remarks()) remarks.push_back(line);
    }
    return so();
  };
  voice.say({"en", "Middle: 8 mm too narrow.", 2, 1}, now);
  EXPECT_TRUE(until([&] { return ended.size() == 1; }));
  voice.say({"ko", "가운데: 8 mm 좁음.", 2, 2}, now);
  EXPECT_TRUE(until([&] { return ended.size() == 2; }));
  voice.say({"xx", "?", 2, 3}, now);
  EXPECT_TRUE(until([&] { return !remarks.empty(); }));
  EXPECT_EQ(ended, (std::vector<std::uint64_t>{1, 2}));
  EXPECT_EQ(said(), "en: Middle: 8 mm too narrow.\nko: 가운데: 8 mm 좁음.\n");
  EXPECT_GT(fs::file_size(folder_ / "last.wav"), 10'000u) << "it is a sound";
  EXPECT_NE(remarks.at(0).find("\"xx\""), std::string::npos);
  EXPECT_EQ(voice.failures(), 0);
}

}  // namespace
}  // namespace onggi::access::speech_dispatcher_test
