#pragma once

#include <string>
#include <vector>

#include "core/figure.h"
#include "report/page/run_data.h"

namespace runout {

/// The part of a line whose x lies within [from, to]; where it crosses an end, the crossing is added.
Polyline clipped(const Polyline& line, double from, double to);

/// The free surface of the deposit (by top) over the bed, local frame, from the uphill end on.
Polyline deposit_surface(const RunData& run);

/// What of the section is worth showing: source and deposit with a margin, local frame.
struct SectionWindow {
    Vec2 low{0, 0}, high{1, 1};
};
SectionWindow section_view(const RunData& run);

/// From the exit point up at the discontinuity angle to where it leaves the source.
Polyline discontinuity_line(const SectionGeometry& geometry);

/// Posts on the ground at both edges of a place, joined at their top; one post where it has no width.
Polyline place_posts(const RunData& run, const PlaceRecord& place, const SectionWindow& view);

/// Ground, source, slip surface, discontinuity line and final deposit, to scale.
Figure section_figure(const RunData& run);

}  // namespace runout
