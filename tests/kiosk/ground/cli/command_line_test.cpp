#include "kiosk/ground/cli/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <streambuf>
#include <vector>

namespace onggi::cli::command_line_test {
namespace {

/// A program of two commands, `turn` and `tool sponge`, and what became of its fields.
class CommandLine : public ::testing::Test {
 protected:
  /// Exit code and what was said, on either stream.
  int run(const std::vector<const char*>& words) {
    std::vector<const char*> arguments{"wheel"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code =
        run_command_line(program_, "1.2", static_cast<int>(arguments.size()), arguments.data());
    said_ = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr();
    return code;
  }
  Result<int> ran(const char* what) {
    ran_ = what;
    return 0;
  }

  std::string pot_, ran_, said_;
  double speed_ = 60;
  std::uint64_t seed_ = 1;
  files::Output json_{files::Output::Kind::json};
  bool left_ = false, right_ = false;
  Command program_{
      .name = "wheel",
      .help = "A wheel.",
      .examples = "Example: wheel turn jar",
      .commands = {{.name = "turn",
                    .help = "Turns it.",
                    .examples = "Example: wheel turn jar --speed 90",
                    .options = {{.name = "pot", .field = &pot_, .help = "A pot", .required = true},
                                {.name = "--speed",
                                 .field = &speed_,
                                 .help = "Turns a minute",
                                 .least = 0.5,
                                 .most = 300,
                                 .shows_default = true},
                                {.name = "--seed", .field = &seed_, .help = "Any", .least = 0},
                                {"--left", &left_, "To the left"},
                                {"--json", &json_, "A report"},
                                {.name = "--right",
                                 .field = &right_,
                                 .help = "To the right",
                                 .excludes = "--left"},
                                {.name = "--secret", .field = &left_, .help = "", .hidden = true}},
                    .run = [this] { return ran("turn"); }},
                   {.name = "tool",
                    .help = "Its tools.",
                    .examples = "Example: wheel tool sponge",
                    .commands = {{.name = "sponge",
                                  .help = "Wets.",
                                  .examples = "Example: wheel tool sponge",
                                  .options = {{"--json", &json_, "A report"}},
                                  .run = [this] { return ran("sponge"); }}}}},
      .run = [this] { return ran("wheel"); }};
};

// The library would split brackets at commas, and take a minus for an option.
TEST_F(CommandLine, WordsAtTheEndArriveAsTheyWereTyped) {
  std::string file;
  std::vector<std::string> words;
  const Command set{
      .name = "set",
      .help = "Sets.",
      .examples = "Example: wheel set a b",
      .options = {{.name = "file", .field = &file, .help = "A file", .required = true},
                  {.name = "WORDS", .field = &words, .help = "any words"}},
      .run = [] { return Result<int>(0); }};
  program_.commands.push_back(set);
  EXPECT_EQ(run({"set", "a.toml", "key", "[1, 2]", "-5", "", "set", "--x", "it's \"q\""}), 0);
  EXPECT_EQ(file, "a.toml");
  EXPECT_EQ(words,
            (std::vector<std::string>{"key", "[1, 2]", "-5", "", "set", "--x", "it's \"q\""}));
  words.clear();
  EXPECT_EQ(run({"set", "a.toml"}), 0);
  EXPECT_TRUE(words.empty());
  EXPECT_EQ(run({"set"}), 2);
  EXPECT_EQ(run({"set", "--help"}), 0);
  EXPECT_NE(said_.find("WORDS: any words"), std::string::npos);
}

TEST_F(CommandLine, fields_are_filled_before_the_command_that_was_named_runs) {
  EXPECT_EQ(run({"turn", "--speed", "90", "jar", "--seed=7", "--right"}), 0) << said_;
  EXPECT_EQ(ran_, "turn");
  EXPECT_EQ(pot_, "jar");
  EXPECT_EQ(speed_, 90);
  EXPECT_EQ(seed_, 7u);
  EXPECT_TRUE(right_);
  EXPECT_EQ(run({"tool", "sponge"}), 0);
  EXPECT_EQ(ran_, "sponge");
  EXPECT_EQ(run({}), 0);
  EXPECT_EQ(ran_, "wheel");
}

TEST_F(CommandLine, what_is_wrong_is_the_inputs_fault_and_nothing_runs) {
  for (const auto& [words, told] : std::vector<std::pair<std::vector<const char*>, const char*>>{
           {{"turn"}, "pot is required"},
           {{"turn", "jar", "--speed", "301"},
            "301 is too much or too little: write a number from 0.5 to 300"},
           {{"turn", "jar", "--speed", "0.4"}, "write a number from 0.5 to 300"},
           {{"turn", "jar", "--speed", ""}, "\"\" is not a number: write one from 0.5 to 300"},
           {{"turn", "jar", "--speed", "fast"}, "fast"},
           {{"turn", "jar", "--speed", "nan"}, "not a finite number"},
           {{"turn", "jar", "--speed", "-nan(1)"}, "--speed"},
           {{"turn", "jar", "--speed", "NaN"}, "not a finite number"},
           {{"turn", "jar", "--speed", "inf"}, "not a finite number"},
           {{"turn", "jar", "--speed", "1e400"}, "not a finite number"},
           {{"turn", "jar", "--seed", "-1"}, "\"-1\" is not a whole number"},
           {{"turn", "jar", "--seed", "x"}, "\"x\" is not a whole number"},
           {{"turn", "jar", "--seed", "99999999999999999999999"}, "is too large"},
           {{"turn", "jar", "--seed", "1.5"}, "not a whole number"},
           {{"turn", ""}, "it is empty: name something\n"},
           {{"turn", "jar", "--json", ""}, "it is empty: name something, or leave the option out"},
           {{"turn", "jar", "--json="}, "--json"},
           {{"turn", "jar", "--left", "--right"}, "excludes"},
           {{"turn", "jar", "bowl"}, "bowl"},
           {{"tool"}, "subcommand is required"},
           {{"spin"}, "spin"}}) {
    ran_.clear();
    EXPECT_EQ(run(words), 2) << told;
    EXPECT_NE(said_.find(told), std::string::npos) << said_;
    EXPECT_NE(said_.find("See wheel --help"), std::string::npos) << said_;
    EXPECT_EQ(ran_, "");
  }
}

TEST_F(CommandLine, an_option_before_the_command_is_told_with_the_words_that_work) {
  // As onggi itself has the options of onggi run.
  program_.options = {{"--speed", &speed_, "Turns a minute"},
                      {"--calm", &left_, "Calmly"},
                      {"--json", &json_, "A report"}};
  for (const auto& [words, told] : std::vector<std::pair<std::vector<const char*>, const char*>>{
           {{"--speed", "90", "turn", "jar"},
            "--speed 90: It stands before the command turn, which does not see it.\n"
            "  Write it behind: wheel turn --speed 90\n"},
           {{"--speed", "90", "turn", "jar", "--speed", "80"}, "wheel turn --speed 90"},
           {{"--json", "a.json", "tool", "sponge"},
            "--json a.json: It stands before the command tool, which does not see it.\n"
            "  Write it behind: wheel tool sponge --json a.json\n"},
           {{"--calm", "tool", "sponge"},
            "--calm: It stands before the command tool, which does not see it.\n"
            "  Leave it out: wheel tool sponge has no --calm.\n"}}) {
    ran_.clear();
    EXPECT_EQ(run(words), 2) << told;
    EXPECT_NE(said_.find(told), std::string::npos) << said_;
    EXPECT_EQ(ran_, "");
  }
  EXPECT_EQ(run({"--speed", "90", "--calm"}), 0) << said_;
  EXPECT_EQ(ran_, "wheel");
}

TEST_F(CommandLine, no_message_repeats_a_control_character_or_a_number_of_hundreds_of_digits) {
  const char* const commands = "\x1b[31mred\a\x7f\xc2\x9b\n\r";
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{commands},
                                             {"turn", "jar", commands},
                                             {"turn", "jar", "--speed", commands},
                                             {"turn", "jar", "--seed", commands},
                                             {"turn", "jar", "--json", "a.json", commands},
                                             {"tool", commands}}) {
    EXPECT_EQ(run(words), 2);
    for (const char c : {'\x1b', '\a', '\x7f', '\r'})
      EXPECT_EQ(said_.find(c), std::string::npos) << said_;
    EXPECT_EQ(said_.find("\xc2\x9b"), std::string::npos);
    EXPECT_EQ(std::count(said_.begin(), said_.end(), '\n'), 2) << said_;
  }
  for (const char* number : {"x", "-1", "1e400", "", "99999999999999999999999"}) {
    EXPECT_EQ(run({"turn", "jar", "--seed", number}), 2) << number;
    EXPECT_LT(said_.size(), 200u) << said_;
  }
}

TEST_F(CommandLine, help_tells_options_defaults_and_examples_and_hides_what_is_hidden) {
  EXPECT_EQ(run({"turn", "--help"}), 0);
  EXPECT_EQ(ran_, "");
  for (const char* words : {"Turns it.", "A pot", "--speed", "Example: wheel turn jar"})
    EXPECT_NE(said_.find(words), std::string::npos) << said_;
  // CLI11 2.3 and 2.4.
  EXPECT_THAT(said_, ::testing::AnyOf(::testing::HasSubstr("=60"), ::testing::HasSubstr("[60]")));
  EXPECT_EQ(said_.find("--secret"), std::string::npos) << said_;
  EXPECT_EQ(run({"--version"}), 0);
  EXPECT_EQ(said_, "wheel 1.2\n");
}

TEST_F(CommandLine, the_manual_is_printed_though_no_command_was_named) {
  program_.run = {};  // as of onggi-lab: one of its commands must be named
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(run({"--manual", "2026-11-22"}), 0) << said_;
  EXPECT_THAT(said_, ::testing::StartsWith(".TH WHEEL"));
  EXPECT_THAT(said_, ::testing::HasSubstr("2026-11-22"));
  EXPECT_THAT(said_, ::testing::HasSubstr("wheel tool sponge"));
  EXPECT_EQ(run({"--help"}), 0);
  EXPECT_THAT(said_, ::testing::Not(::testing::HasSubstr("--manual")));
}

TEST_F(CommandLine, a_problem_is_printed_and_its_exit_code_is_the_programs) {
  program_.run = []() -> Result<int> { return problem("the wheel", "It stands.", "Push it.", 1); };
  EXPECT_EQ(run({}), 1);
  EXPECT_EQ(said_, to_text(Problem{"the wheel", "It stands.", "Push it.", 1}) + "\n");
  program_.run = []() -> Result<int> { return 2; };
  EXPECT_EQ(run({}), 2);
  EXPECT_EQ(said_, "");
}

TEST_F(CommandLine, what_was_printed_and_could_not_be_written_is_told_in_a_line) {
  struct Full : std::streambuf {
    int overflow(int) override { return traits_type::eof(); }
  } full;
  program_.run = []() -> Result<int> {
    std::cout << "a report\n";
    return 0;
  };
  for (const int wrong : {0, 2}) {
    if (wrong == 2)
      program_.run = []() -> Result<int> {
        std::cout << "a report\n";
        return 2;
      };
    testing::internal::CaptureStderr();
    std::streambuf* const old = std::cout.rdbuf(&full);
    const char* const words[] = {"wheel"};
    const int code = run_command_line(program_, "1.2", 1, words);
    std::cout.rdbuf(old);
    std::cout.clear();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(code, std::max(1, wrong));
    EXPECT_THAT(said, ::testing::StartsWith("standard output: Not everything"));
  }
}

TEST_F(CommandLine, what_is_thrown_is_the_programs_fault) {
  program_.run = []() -> Result<int> { throw std::runtime_error("the belt broke"); };
  EXPECT_EQ(run({}), 1);
  EXPECT_NE(said_.find("wheel: the belt broke"), std::string::npos) << said_;
  EXPECT_NE(said_.find("fault of the program"), std::string::npos) << said_;
}

}  // namespace
}  // namespace onggi::cli::command_line_test
