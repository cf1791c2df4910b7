#pragma once

#include <cstdint>
#include <span>

namespace runout::fuzz {

// What any bytes may do to the parts that read what a user gave: end with an InputError that says something,
// or with a value that keeps its promises. Each aborts the program otherwise, which a fuzzer takes for a
// finding.

/// Bytes as a section in CSV.
void read_section(std::span<const std::uint8_t> bytes);

/// Bytes as a section in whatever format they look like.
void read_any_section(std::span<const std::uint8_t> bytes);

/// Bytes as a case file, then each of its lines as an override on the command line.
void read_case_file(std::span<const std::uint8_t> bytes);

/// Bytes as numbers: points of a section, a type of source and all that may be said of it.
void derive_any_source(std::span<const std::uint8_t> bytes);

/// Bytes as a study, with its combinations where they are few.
void read_study_file(std::span<const std::uint8_t> bytes);

/// A valid database in which bytes are changed, four at a time: three for the place, one for what stands
/// there. Then all that is ever read of a database is read.
void read_damaged_database(std::span<const std::uint8_t> bytes);

/// Bytes as layers of a map: names, values, shapes, coordinate systems.
void write_any_map(std::span<const std::uint8_t> bytes);

}  // namespace runout::fuzz
