#pragma once

#include <string>

namespace runout {

// Standard output. Texts may hold names that came from a file or a database; whatever they hold, the terminal
// shows it and does not obey it.

void print_text(const std::string& text);
void print_json(const std::string& json);

}  // namespace runout
