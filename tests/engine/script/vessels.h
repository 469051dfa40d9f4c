#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/profile/profile.h"

/// Outlines after vessels of many cultures, from their published dimensions, for tests.
namespace onggi::vessels {

/// (height, outer radius) in centimetres; straight between, with a 5 mm wall.
inline Profile drawn(const std::vector<std::pair<double, double>>& outline) {
  Profile p;
  for (const auto& [h, r] : outline) p.points.push_back({h / 100, r / 100, r / 100 - 0.005});
  return p;
}

inline Profile moon_jar() {
  return drawn({{0, 6},
                {2, 8.5},
                {5, 12},
                {10, 14.5},
                {15, 15.1},
                {20, 14.6},
                {25, 12},
                {28, 8.5},
                {29, 7.2},
                {30.5, 7.1}});
}
inline Profile maebyeong() {
  return drawn({{0, 7.9},
                {5, 7.7},
                {12, 8},
                {20, 9.5},
                {28, 12.5},
                {34, 14},
                {38, 13},
                {40.5, 8},
                {41.5, 4},
                {42.5, 3.4},
                {43.9, 3.6}});
}
inline Profile kylix() {
  return drawn({{0, 6},
                {0.8, 6},
                {1.5, 3},
                {3, 1.8},
                {5, 1.8},
                {6.3, 3},
                {7.2, 7},
                {8.5, 11},
                {10, 14},
                {13, 16.2}});
}
inline Profile tea_bowl() {
  return drawn({{0, 2.6}, {0.8, 2.65}, {1, 3}, {2, 4.6}, {4, 6.3}, {6, 7.3}, {8, 7.75}});
}
inline Profile bottle() {
  return drawn({{0, 5},
                {3, 6.5},
                {8, 8},
                {12, 7.5},
                {15, 5},
                {17, 3},
                {20, 2},
                {26, 1.7},
                {28, 2},
                {30, 2.8}});
}
inline Profile cylinder() { return drawn({{0, 7}, {15, 7.1}, {30, 7}}); }
inline Profile lekythos() {
  return drawn({{0, 4},
                {1, 4.2},
                {2, 3},
                {3, 3.5},
                {6, 5},
                {15, 6.2},
                {23, 6.2},
                {25.5, 5},
                {27, 2.2},
                {31, 1.7},
                {33, 2.8},
                {36, 3}});
}
inline Profile amphora() {
  return drawn({{0, 6},
                {1, 5.5},
                {2, 4},
                {8, 7},
                {25, 17},
                {40, 20},
                {48, 17},
                {52, 11},
                {54, 9},
                {60, 9},
                {62.2, 11}});
}

inline std::vector<std::pair<std::string, Profile>> all() {
  return {{"moon jar", moon_jar()}, {"maebyeong", maebyeong()}, {"kylix", kylix()},
          {"tea bowl", tea_bowl()}, {"bottle", bottle()},       {"cylinder", cylinder()},
          {"lekythos", lekythos()}, {"amphora", amphora()}};
}

}  // namespace onggi::vessels
