#include "kiosk/ground/files/output.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>

#include <thread>

#include "kiosk/ground/files/files_read.h"
#include "kiosk/ground/files/read_file.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::output_test {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Kind = Output::Kind;

class AnOutput : public ::testing::Test {
 protected:
  // A deleted file's inode comes back as another test's file.
  void TearDown() override {
    note_reads(false);
    note_reads(true);
  }
  std::string path(const std::string& name) const { return (scratch_.path() / name).string(); }
  void there(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  Output to(const std::string& name, Kind kind = Kind::json) const {
    return Output(kind, path(name));
  }
  mode_t mode(const std::string& name) const {
    struct stat info {};
    return ::lstat(path(name).c_str(), &info) == 0 ? info.st_mode : 0;
  }
  ScratchFolder scratch_;
};

TEST_F(AnOutput, of_a_new_name_is_written_and_one_of_its_kind_is_replaced) {
  for (const std::string text : {"{\"height\": 1}\n", "[2, 3]\n"}) {
    ASSERT_TRUE(to("report.json").write(text));
    EXPECT_EQ(content(path("report.json")), text);
  }
  EXPECT_THAT(names_in(scratch_.path()), ElementsAre("report.json"));
  EXPECT_TRUE(Output(Kind::json).write(std::string("nowhere")));
}

TEST_F(AnOutput, never_takes_the_place_of_a_file_of_another_kind_unless_it_is_forced) {
  const std::string glb("glTF\2\0\0\0", 8), png("\x89PNG\r\n\x1a\n", 8);
  const std::vector<std::pair<std::string, std::string>> all{
      {"scan.glb", glb},
      {"photo.png", png},
      {"plot.svg", "<?xml version=\"1.0\"?>\n<svg/>"},
      {"rows.csv", "rows,force\n1,\"2,5\"\n3,4\n"},
      {"hum.wav", std::string("RIFF\x24\0\0\0WAVEfmt ", 16)},
      {"report.tar.gz", "\x1f\x8b\x08 and so on"},
      {"photo.webp", std::string("RIFF\x24\0\0\0WEBPVP8 ", 16)},
      {"report.json", "{\"height\": 1}"},
      {"scan.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": []}"},
      {"vessel.toml", "[label.en]\ntitle = \"A, jar\"\n"},
      {"pot.stl", std::string(80, ' ') + std::string("\2\0\0\0", 4) + std::string(100, 'x')},
      {"cut.stl", std::string(80, ' ') + std::string("\2\0\0\0", 4) + std::string(99, 'x')},
      {"letter.txt", "Dear curator, one line,\nand another.\n"}};
  const auto its = [](const std::string& name) {
    return name == "scan.glb"                          ? "glb"
           : name == "report.json"                     ? "json"
           : name == "rows.csv"                        ? "csv"
           : name == "report.tar.gz"                   ? "archive"
           : name == "hum.wav"                         ? "wav"
           : name == "pot.stl"                         ? "stl"
           : name == "photo.png" || name == "plot.svg" ? "picture"
                                                       : "none";
  };
  const std::vector<std::pair<std::string, Kind>> kinds{
      {"glb", Kind::glb},         {"json", Kind::json}, {"csv", Kind::csv},
      {"picture", Kind::picture}, {"wav", Kind::wav},   {"archive", Kind::archive},
      {"stl", Kind::stl}};
  for (const auto& [name, text] : all)
    for (const auto& [word, kind] : kinds) {
      there(name, text);
      Output out = to(name, kind);
      const auto said = out.check();
      EXPECT_EQ(said.has_value(), word == its(name)) << word << " over " << name;
      EXPECT_EQ(out.write(std::string("new")).has_value(), said.has_value());
      EXPECT_EQ(content(path(name)), said ? "new" : text);
      if (said) continue;
      EXPECT_EQ(said.error().exit_code, 2);
      EXPECT_THAT(said.error().remedy, HasSubstr("--force"));
      out.force();
      ASSERT_TRUE(out.write(std::string("new")));
      EXPECT_EQ(content(path(name)), "new");
    }
}

TEST_F(AnOutput, has_a_name_that_ends_as_its_kind_does_or_in_nothing_that_is_known) {
  const std::pair<const char*, Kind> good[] = {
      {"a.json", Kind::json}, {"a.png", Kind::picture},    {"a.SVG", Kind::picture},
      {"a.glb", Kind::glb},   {"a.tar.gz", Kind::archive}, {"a.tgz", Kind::archive},
      {"a", Kind::picture},   {"tmp.Xq3", Kind::json},     {"a.txt", Kind::json},
      {"a.json", Kind::json}, {"a.2026", Kind::csv},       {"a.WAV", Kind::wav},
      {"a.stl", Kind::stl},   {"a.PNG", Kind::png},        {"a.jfif", Kind::png}};
  for (const auto& [name, kind] : good) EXPECT_TRUE(to(name, kind).check()) << name;
  const std::pair<const char*, Kind> wrong[] = {
      {"q.gif", Kind::picture}, {"q.jpg", Kind::picture}, {"q.JPEG", Kind::picture},
      {"q.json", Kind::csv},    {"q.csv", Kind::json},    {"q.pdf", Kind::picture},
      {"q.gltf", Kind::glb},    {"q.mp3", Kind::wav},     {"q.zip", Kind::archive},
      {"q.toml", Kind::json},   {"q.svg", Kind::png},     {"q.glb", Kind::stl}};
  for (const auto& [name, kind] : wrong) {
    Output out = to(name, kind);
    const auto said = out.write(std::string("x"));
    ASSERT_FALSE(said) << name;
    EXPECT_EQ(said.error().exit_code, 2);
    EXPECT_THAT(said.error().what, HasSubstr("The name ends in ." + std::string(name).substr(2)));
    EXPECT_FALSE(fs::exists(path(name)));
    out.force();
    EXPECT_TRUE(out.check()) << name;
  }
}

TEST_F(AnOutput, may_take_the_place_of_an_empty_file_and_keeps_its_rights) {
  there("empty.json", "");
  fs::permissions(path("empty.json"), fs::perms::owner_all | fs::perms::group_read);
  // Only root gives files away; anyone else's is their own already.
  const uid_t owner = ::geteuid() == 0 ? 12345 : ::geteuid();
  ASSERT_EQ(::chown(path("empty.json").c_str(), owner, static_cast<gid_t>(-1)), 0);
  ASSERT_TRUE(to("empty.json", Kind::json).write(std::string("{}")));
  struct stat info {};
  ASSERT_EQ(::stat(path("empty.json").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 07777, 0740u);
  EXPECT_EQ(info.st_uid, owner);
}

TEST_F(AnOutput, never_takes_the_place_of_what_this_run_has_read_by_whatever_name) {
  there("scan.json", "{\"old\": 1}");
  fs::create_symlink(path("scan.json"), path("link.json"));
  fs::create_hard_link(path("scan.json"), path("other.json"));
  ASSERT_TRUE(to("scan.json").check());
  ASSERT_TRUE(read_file(path("link.json"), 100));
  for (const char* name : {"scan.json", "link.json", "other.json"}) {
    Output out = to(name);
    out.force();
    const auto said = out.write(std::string("{}"));
    ASSERT_FALSE(said) << name;
    EXPECT_THAT(said.error().what, HasSubstr("This command reads the file"));
    EXPECT_EQ(said.error().exit_code, 2);
  }
  EXPECT_EQ(content(path("scan.json")), "{\"old\": 1}");
}

TEST_F(AnOutput, never_makes_a_folder) {
  const auto said = to("no/such/report.json").write(std::string("{}"));
  ASSERT_FALSE(said);
  EXPECT_EQ(said.error().exit_code, 2);
  EXPECT_THAT(said.error().remedy, HasSubstr("mkdir -p"));
  EXPECT_THAT(names_in(scratch_.path()), IsEmpty());
  there("file", "x");
  EXPECT_FALSE(to("file/report.json").check());
  EXPECT_FALSE(to("").check());
  EXPECT_FALSE(Output(Kind::json, path("new") + "/").check());
}

TEST_F(AnOutput, through_a_link_writes_what_it_leads_to) {
  there("real.json", "{}");
  fs::create_symlink("real.json", path("link.json"));
  fs::create_symlink("gone.json", path("lost.json"));
  ASSERT_TRUE(to("link.json").write(std::string("{\"new\": 1}")));
  EXPECT_TRUE(S_ISLNK(mode("link.json")));
  EXPECT_EQ(content(path("real.json")), "{\"new\": 1}");
  EXPECT_FALSE(to("lost.json").write(std::string("{}")));
  EXPECT_TRUE(S_ISLNK(mode("lost.json")));
  EXPECT_FALSE(fs::exists(path("gone.json")));
}

TEST_F(AnOutput, to_a_pipe_is_for_its_reader_and_without_one_is_refused_at_once) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  const auto said = to("pipe").write(std::string("{}"));
  ASSERT_FALSE(said);
  EXPECT_THAT(said.error().what, HasSubstr("No program reads"));
  const std::string much(300000, 'x');  // more than a pipe holds
  std::string got;
  const int end = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  ::fcntl(end, F_SETFL, 0);
  std::thread reader([&] {
    char some[5000];
    while (got.size() < much.size())
      if (const ssize_t n = ::read(end, some, sizeof some); n > 0)
        got.append(some, static_cast<std::size_t>(n));
  });
  EXPECT_TRUE(to("pipe").write(much));
  reader.join();
  ::close(end);
  EXPECT_EQ(got, much);
  EXPECT_TRUE(S_ISFIFO(mode("pipe")));
}

TEST_F(AnOutput, to_a_device_is_written_and_the_device_stays) {
  // Nodes of one's own are for root; the system's are for everybody.
  if (::mknod(path("null").c_str(), S_IFCHR | 0666, ::makedev(1, 3)) == 0) {
    EXPECT_TRUE(to("null").write(std::string("{}")));
    EXPECT_TRUE(S_ISCHR(mode("null")));
  }
  EXPECT_TRUE(Output(Kind::glb, "/dev/null").write(std::string("{}")));
  const auto full = Output(Kind::glb, "/dev/full").write(std::string("{}"));
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().exit_code, 1);
  EXPECT_EQ(full.error().what, "The disk is full.");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(AnOutput, to_a_disk_a_socket_or_a_folder_is_refused) {
  fs::create_directory(path("folder"));
  EXPECT_FALSE(to("folder").write(std::string("{}")));
  const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", path("socket").c_str());
  ASSERT_EQ(::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_FALSE(to("socket").write(std::string("{}")));
  EXPECT_TRUE(S_ISSOCK(mode("socket")));
  ::close(fd);
  // A number that no driver has: even a mistake harms nobody.
  if (::mknod(path("disk").c_str(), S_IFBLK | 0600, ::makedev(240, 77)) == 0) {
    const auto said = to("disk").write(std::string("{}"));
    ASSERT_FALSE(said);
    EXPECT_THAT(said.error().what, HasSubstr("disk"));
    EXPECT_TRUE(S_ISBLK(mode("disk")));
  }
}

TEST_F(AnOutput, of_a_dash_goes_to_standard_output_and_so_does_its_file) {
  const int status = in_child([&] {
    const int out = ::open(path("out").c_str(), O_WRONLY | O_CREAT, 0600);
    ::dup2(out, STDOUT_FILENO);
    const Output dash(Kind::json, "-"), same(Kind::json, path("out"));
    return dash.to_stdout() && same.to_stdout() && dash.clashes_with(same) &&
           dash.write(std::string("{}\n")) && same.write(std::string("[]\n")) &&
           content(path("out")) == "{}\n[]\n" && !fs::exists("-");
  });
  EXPECT_EQ(status, 0);
  const int full = in_child([&] {
    ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO);
    const auto said = Output(Kind::json, "-").write(std::string("{}"));
    return !said && said.error().exit_code == 1;
  });
  EXPECT_EQ(full, 0);
}

TEST_F(AnOutput, clashes_with_another_of_the_same_file_but_not_of_the_same_device) {
  there("a.json", "{}");
  fs::create_symlink("a.json", path("b.json"));
  EXPECT_TRUE(to("a.json").clashes_with(to("b.json")));
  EXPECT_TRUE(to("new").clashes_with(to("./new")));
  EXPECT_FALSE(to("new").clashes_with(to("a.json")));
  EXPECT_FALSE(to("new").clashes_with(Output(Kind::glb)));
  EXPECT_FALSE(Output(Kind::json, "/dev/null").clashes_with(Output(Kind::json, "/dev/null")));
  // As typed in a folder: none of these names is there yet.
  const fs::path here = fs::current_path();
  for (const fs::path& name : {fs::path("./not_there"),
                               fs::path("..") / here.filename() / "not_there", here / "not_there"})
    EXPECT_TRUE(Output(Kind::json, "not_there").clashes_with(Output(Kind::csv, name.string())))
        << name;
}

}  // namespace
}  // namespace onggi::files::output_test
