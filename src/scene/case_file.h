#pragma once

#include <string>

#include "scene/case_spec.h"

namespace runout {

/// Reads FILE: a case (.toml), or a bare section (.csv, .dxf, LandXML, or lines such as .gpkg), which counts
/// as a case that says nothing but its section. Throws InputError: no such file, wrong kind of file, TOML
/// that does not parse, unknown key, value out of range.
CaseSpec read_case(const std::string& path);

/// One value from the command line: `key` as in a case file, `text` without TOML quotes. Replaces what the
/// file said; paths are relative to the working directory. `option` ("--set", "--friction-angle") is named in
/// errors. Throws InputError.
void override_value(CaseSpec& spec, const std::string& key, const std::string& text,
                    const std::string& option);

}  // namespace runout
