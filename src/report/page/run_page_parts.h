#pragma once

#include "report/page/page.h"
#include "report/page/run_data.h"

namespace runout {

// The sections of a run's page. A new one is a function here and a line in run_page.cpp.

PageSection answer_section(const RunData& run);
PageSection warnings_section(const RunData& run);
PageSection picture_section(const RunData& run);
PageSection animation_section(const RunData& run);
PageSection motion_section(const RunData& run);
PageSection deposit_section(const RunData& run);
PageSection envelope_section(const RunData& run);
PageSection places_section(const RunData& run);
PageSection stages_section(const RunData& run);
PageSection accuracy_section(const RunData& run);
PageSection effects_section(const RunData& run);
PageSection inputs_section(const RunData& run);
PageSection further_section(const RunData& run);
PageSection provenance_section(const RunData& run);

/// The error bar of the run-out with its origin, or that there is none.
std::string numerical_error_words(const RunData& run);

/// What a reader must know before using the numbers, a sentence each; empty when there is nothing.
std::vector<std::string> run_warnings(const RunData& run);

/// What the model leaves out, whatever the run.
std::vector<std::string> validity_envelope();

}  // namespace runout
