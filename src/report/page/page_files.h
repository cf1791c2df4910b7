#pragma once

#include <string_view>

/// Files that reports need, compiled into the program (src/CMakeLists.txt).
namespace runout::page_file {

std::string_view charting_library();  ///< Chart.js, with its licence in its head
std::string_view style();             ///< report/page/report.css
std::string_view charts();            ///< report/page/charts.js
std::string_view animation();         ///< report/page/animation.js

std::string_view travel_angles();  ///< report/data/travel_angles.csv

}  // namespace runout::page_file
