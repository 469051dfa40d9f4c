#pragma once

#include <string>

#include "kiosk/ground/files/json.h"
#include "kiosk/lab/measure/naive_table.h"

namespace onggi::pages {

/// {scene, machine, pointer, naive: [visit...], careful: [visit...]}: every visit with all its
/// looks.
files::Json json_of(const measure::NaiveTable& table);
/// The table for people: a line for each moment and vessel, then the careful hand's pots.
std::string text_of(const measure::NaiveTable& table);

}  // namespace onggi::pages
