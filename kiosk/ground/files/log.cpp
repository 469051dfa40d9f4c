#include "kiosk/ground/files/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <ctime>
#include <mutex>

#include "engine/base/plain_text.h"

namespace onggi::files {

namespace {
spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> log = [] {
    auto made = spdlog::stderr_logger_mt("onggi");
    made->set_pattern("%Y-%m-%d %H:%M:%S.%e %^%l%$ %v");
    made->flush_on(spdlog::level::info);
    return made;
  }();
  return *log;
}

std::mutex trouble_mutex;
std::optional<Trouble> trouble;  // guarded by it
}  // namespace

void log_line(const std::string& line) { logger().info("{}", terminal::plain(line)); }
void log_problem(const Problem& p) {
  logger().warn("{}", to_text(p));
  const std::lock_guard lock(trouble_mutex);
  trouble =
      Trouble{p, static_cast<std::int64_t>(std::time(nullptr)), trouble ? trouble->count + 1 : 1};
}
void log_problems(const std::vector<Problem>& problems) {
  for (const Problem& p : problems) log_problem(p);
}

std::optional<Trouble> last_trouble() {
  const std::lock_guard lock(trouble_mutex);
  return trouble;
}

}  // namespace onggi::files
