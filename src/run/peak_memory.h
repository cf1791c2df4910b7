#pragma once

namespace runout {

/// Watches the greatest resident memory of the program from when it is made. Runs side by side in one program
/// see the sum.
class PeakMemory {
  public:
    PeakMemory();
    /// MB (10^6 bytes); 0 where the system does not tell.
    [[nodiscard]] double megabytes() const;
};

}  // namespace runout
