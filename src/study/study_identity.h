#pragma once

#include <string>
#include <vector>

#include "study/study_file.h"

namespace runout {

/// What a study is known by beside its name: its file as it stood, and a hash of all files that it takes its
/// scenarios from - its case, and the sections, rasters and records that case or study name. Two studies with
/// one text ask the same. Throws InputError: a case that cannot be read.
std::string study_identity(const Study& study);

/// The files that a study reads, itself among them: no output may replace them. Throws InputError as above.
std::vector<std::string> study_files(const Study& study);

}  // namespace runout
