#include "kiosk/app/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <iostream>

namespace onggi::app {

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
}  // namespace

void log_line(const std::string& line) { logger().info("{}", line); }
void log_problem(const Problem& p) { logger().warn("{}", to_text(p)); }
void log_problems(const std::vector<Problem>& problems) {
  for (const Problem& p : problems) log_problem(p);
}

int exit_with(const Problem& p) {
  std::cerr << to_text(p) << '\n';
  return p.exit_code;
}

}  // namespace onggi::app
