#pragma once

#include <string>
#include <vector>

#include "profile/profile.h"
#include "profile/section_file.h"
#include "scene/case_spec.h"

namespace runout {

/// The ground, and the mass that is drawn with it.
struct Ground {
    Profile profile;
    DrawnMass mass;
};

/// Whether the section is a line on a map: not in a file of its own, and not a line that names no coordinate
/// system, which is a section drawn in a local one.
bool is_on_map(const SectionSpec& section);

/// Reads the section, whatever its format. Throws InputError, also for a key that would have no effect on
/// this format.
Ground read_ground(const CaseSpec& spec);

/// The source of the case, completed by what is drawn unless the case says otherwise; what was taken from the
/// drawing is told in `assumed`. Throws InputError when the drawing has an outline and a slip line, and the
/// case does not choose.
SourceSpec with_drawn_mass(const CaseSpec& spec, const DrawnMass& mass, std::vector<std::string>& assumed);

}  // namespace runout
