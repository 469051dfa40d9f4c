// main() of every test program. A program whose tests all skip exits with 77, which ctest tells as
// skipped. Where ONGGI_TESTS_RAN names a file, each test adds a line to it: "ran" or "skipped", its
// name, and why it skipped.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace {

constexpr int kAllSkipped = 77;

class Told : public ::testing::EmptyTestEventListener {
 public:
  Told(const char* path, const std::string& program) : program_(program) {
    if (path != nullptr) file_ = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  }
  void OnTestEnd(const ::testing::TestInfo& test) override {
    if (file_ < 0) return;
    std::string line = test.result()->Skipped() ? "skipped " : "ran ";
    line += program_ + ":" + test.test_suite_name() + "." + test.name();
    for (int n = 0; n < test.result()->total_part_count(); ++n) {
      const ::testing::TestPartResult& part = test.result()->GetTestPartResult(n);
      if (part.skipped()) line += std::string("  ") + part.message();
    }
    std::replace(line.begin(), line.end(), '\n', ' ');
    line += '\n';
    // One write, for other programs add lines meanwhile.
    if (write(file_, line.data(), line.size()) < 0) std::perror("ONGGI_TESTS_RAN");
  }

 private:
  std::string program_;
  int file_ = -1;
};

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const std::string program = argv[0];
  ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  all.listeners().Append(
      new Told(std::getenv("ONGGI_TESTS_RAN"), program.substr(program.rfind('/') + 1)));
  const int failed = RUN_ALL_TESTS();
  const bool skipped =
      all.skipped_test_count() > 0 && all.skipped_test_count() == all.test_to_run_count();
  return failed == 0 && skipped ? kAllSkipped : failed;
}
