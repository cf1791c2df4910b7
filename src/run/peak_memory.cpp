#include "run/peak_memory.h"

#include <fstream>
#include <limits>
#include <string>

namespace runout {

// Linux: "5" sets the high-water mark VmHWM back to what is resident now (man 5 proc).
PeakMemory::PeakMemory() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

double PeakMemory::megabytes() const {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kibibytes = 0;
        if (word == "VmHWM:" && status >> kibibytes) return kibibytes * 1024e-6;
        status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return 0;
}

}  // namespace runout
