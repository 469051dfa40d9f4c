#pragma once

#include <string>

namespace onggi::tuning {

/// The processor's name and the number of cores: "AMD EPYC, 2 cores".
std::string machine_name();

/// Processor time of the calling thread, microseconds; other work of the machine does not count.
double thread_us();

}  // namespace onggi::tuning
