#pragma once

#include <span>
#include <string>

#include "accuracy/study.h"

namespace runout {

/// Title of the work-precision chart of a scene.
std::string chart_title(const std::string& scene);

/// The page on what accuracy costs, in Markdown, from stored studies: what a percent costs on each scene,
/// where it stops paying, whether the chosen settings kept their promise, then scene by scene the ladder,
/// what it says, the chart at `<picture_folder>/<scene>.svg`, and the settings that failed.
std::string accuracy_page(std::span<const AccuracyStudy> studies, const std::string& picture_folder);

}  // namespace runout
