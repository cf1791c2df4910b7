#pragma once

#include <atomic>
#include <string>

#include "store/store.h"

namespace runout {

/// Lets the store wait for other programs as long as it takes, so that no run that has ended is thrown away,
/// and says every ten seconds what it waits for - with --quiet too: nobody is to take it for hanging.
/// `interrupt` ends the waiting; it outlives the store's last write.
void wait_for_others(Store& store, const std::string& path, const std::atomic<bool>& interrupt);

}  // namespace runout
