#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/neighbours.h"
#include "engine/soil.h"
#include "engine/wall.h"

namespace runout {

/// Sums of a field over the coarse cells that the nodes of a chunk are in. Those are near each other, so that
/// the cells are few.
struct CellSums {
    int low = 0;              ///< the lowest cell
    std::vector<double> sum;  ///< per cell from `low` on

    void clear() { std::fill(sum.begin(), sum.end(), 0.0); }
};

/// What the coarse level adds to a residual's correction.
struct CoarseCorrection {
    const double* value = nullptr;  ///< one per cell, valid until the next call
    double product = 0;             ///< with the residual: r . P A_c^-1 P^T r
};

/// Coarse level of the pressure preconditioner: one unknown per square cell of four spacings, piecewise
/// constant, factorised by CHOLMOD. A factor of some steps ago still preconditions well; the particles carry
/// the number of their cell with them until the next `build`.
class CoarseLevel {
  public:
    CoarseLevel();
    ~CoarseLevel();
    CoarseLevel(const CoarseLevel&) = delete;
    CoarseLevel& operator=(const CoarseLevel&) = delete;

    /// Factorises P^T A P of the matrix diag(diagonal) - k over the nodes with free != 0. On return
    /// `aggregate` has each node's cell (-1: none). Cells of `cell` metres.
    void build(const Neighbours& n, const Soil& soil, const Wall& wall, const std::vector<double>& diagonal,
               const std::vector<char>& free, double cell, std::vector<int>& aggregate);

    /// A_c^-1 P^T r, given the sums P^T r chunk by chunk.
    CoarseCorrection solve(const std::vector<CellSums>& sums);

  private:
    struct Factor;
    std::unique_ptr<Factor> factor_;
};

}  // namespace runout
