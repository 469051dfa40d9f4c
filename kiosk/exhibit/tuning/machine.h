#pragma once

#include <string>

namespace onggi::tuning {

/// The processor's name and how many cores there are: "AMD EPYC, 2 cores".
std::string machine_name();

/// Microseconds that the calling thread has worked: what else the machine does is not in it.
double thread_us();

}  // namespace onggi::tuning
