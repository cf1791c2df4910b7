#pragma once

#include "source/ground_walk.h"
#include "source/polygons.h"
#include "source/source.h"

namespace runout {

// One function a type; each expects a spec that check_spec has passed and throws InputError as derive_source
// does.
Source derive_rectangle(const Profile& profile, const SourceSpec& spec);
Source derive_a(const Profile& profile, const SourceSpec& spec);
Source derive_b(const Profile& profile, const SourceSpec& spec);
Source derive_c(const Profile& profile, const SourceSpec& spec);
Source derive_polygon(const Profile& profile, const SourceSpec& spec);
Source derive_slip_surface(const Profile& profile, const SourceSpec& spec);

/// Whether an area is no more than what points on one line enclose after rounding.
bool is_film(double area, const std::vector<Vec2>& points);

/// Reads everything off the region that a Source tells; `head` and `exit` in the local frame. Throws
/// InputError where the mass has no thickness.
Source source_from(const Region& region, const Profile& profile, const SourceSpec& spec, const Vec2& exit,
                   const Vec2& head);

/// Throws InputError (source.type) where the section has no face to fail.
void require_face(const Profile& profile, const SourceSpec& spec);

/// The lowest point of the cut, between toe and crest, at an elevation above the toe that follows from `key`.
/// Throws InputError, naming `what` is placed there, when the face does not reach it.
GroundPoint on_face(const Profile& profile, const SourceSpec& spec, double elevation, double SourceSpec::*key,
                    const std::string& what);

}  // namespace runout
