#pragma once

#include <string>

#include "core/figure.h"
#include "scene/scene.h"

namespace runout {

/// What stands on a section: a source, or none where it has not been derived.
struct SectionView {
    const Profile& profile;
    const Source* source = nullptr;
};

/// The line through P at the discontinuity angle, from P to where it leaves the source or its bed, in the
/// local frame.
Polyline discontinuity_line(const Source& source);

/// Toe, crest, face and source in words, points as (chainage, elevation).
std::string section_text(const SectionView& view);

/// The section drawn with characters: `.` ground, `#` source, `/` or `\` the line of the discontinuity angle,
/// T toe, C crest, P exit point. `columns` wide.
std::string section_drawing(const SectionView& view, int columns);

/// The same as a figure, for svg_chart.
Figure section_figure(const SectionView& view, const std::string& title);

}  // namespace runout
