#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "source/source.h"

namespace runout {

/// A number of the SourceSpec that a case file may give.
using SpecKey = double SourceSpec::*;

/// What says where on the section a source lies.
enum class Placement {
    by_drop_height,   ///< anywhere on the face; at one of its ends when no drop height is given
    below_crest,      ///< by its height and its area, which reaches behind the crest; the drop height follows
    by_outline,       ///< by the corners of the mass
    by_slip_surface,  ///< by the points of the slip surface
};

/// All that tells one type of source from another. The case file's words and checks follow from it.
struct SourceTypeRow {
    SourceType type;
    std::string_view name;  ///< in case files, the database and reports
    Placement placement;
    std::span<const SpecKey> keys;                        ///< the numbers that the type uses
    std::size_t fewest_points;                            ///< of source.points; 0: the type takes none
    Source (*derive)(const Profile&, const SourceSpec&);  ///< gets a spec that check_spec has passed
};

/// One row a type, in the order of the documentation.
std::span<const SourceTypeRow> source_types();

/// Throws InputError (source.type) for a value that has no row.
const SourceTypeRow& row_of(SourceType type);

/// The type of this name. Throws InputError (source.type) when there is none.
SourceType source_type_named(std::string_view name);

bool uses(SourceType type, SpecKey key);
bool takes_points(SourceType type);

/// The key source.height_m that says what this source is: from its exit point up to its head, or up to the
/// crest where the mass reaches behind it, m.
double height_of(const Profile& profile, const Source& source);

}  // namespace runout
