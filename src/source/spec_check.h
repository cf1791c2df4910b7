#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "source/source_types.h"

namespace runout {

inline bool given(double value) {
    return !std::isnan(value);
}

/// The types that use this key of a case file ("source.area_m2"), in their order; none where the key is not
/// one that hangs on the type.
std::vector<SourceType> types_using(std::string_view key);

/// Throws InputError: a key that the type does not use, a number outside its range, points where none belong
/// or none where they do, a scarp not steeper than the base.
void check_spec(const SourceSpec& spec);

/// The value of a key that the type cannot do without. Throws InputError when it is not given.
double required(const SourceSpec& spec, SpecKey key, const std::string& valid);

/// Throws the InputError that names the key, its place and its value as the user gave it.
[[noreturn]] void refuse(const SourceSpec& spec, SpecKey key, const std::string& problem,
                         const std::string& valid);
/// The same for a key that is not a number: "source.points", "source.type".
[[noreturn]] void refuse(const SourceSpec& spec, const std::string& key, const std::string& problem,
                         const std::string& valid);

/// Two statements of one quantity agree when they differ by no more than the rounding of a decimal.
bool agree(double a, double b);

/// A point of the local frame in the coordinates of the file, for an error message: "[41.547, 12]".
std::string shown(const Profile& profile, const Vec2& local);

/// A figure for an error message.
std::string figure(double value);

}  // namespace runout
