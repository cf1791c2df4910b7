#include "program/output_option.h"

namespace runout {

void add_overwrite_option(CLI::App& subcommand, OutputRules& rules) {
    subcommand
        .add_flag("--overwrite", rules.overwrite,
                  "Replace files that exist, also such as this program did not write or that were edited")
        ->group("Output");
}

}  // namespace runout
