#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/pairs/particle_system.h"

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

/// What the fine level gives to make a coarse one of: the matrix diag(diagonal) - k over the nodes with
/// free != 0.
struct FineLevel {
    const ParticleSystem& particles;
    const std::vector<double>& diagonal;
    const std::vector<char>& free;
};

/// Coarse level of the pressure preconditioner: one unknown per square cell of four spacings, piecewise
/// constant, factorised by CHOLMOD. A factor of some steps ago still preconditions well; the particles carry
/// the number of their cell with them until the next `build`.
class CoarseLevel {
  public:
    explicit CoarseLevel(double spacing);
    ~CoarseLevel();
    CoarseLevel(const CoarseLevel&) = delete;
    CoarseLevel& operator=(const CoarseLevel&) = delete;

    /// The nodes go on with the cells and the factor of the last `build`.
    void carry_on(const FineLevel& fine);
    /// Makes new cells and factorises P^T A P.
    void build(const FineLevel& fine);
    /// There is nothing to go on with.
    [[nodiscard]] bool empty() const { return wall_cell_.empty(); }
    /// The wall is another one from now on.
    void forget_wall() { wall_cell_.clear(); }

    /// Each node's cell, -1: none.
    [[nodiscard]] const std::vector<int>& cell() const { return cell_; }
    /// The place for the sums P^T r of a chunk.
    [[nodiscard]] CellSums& sums(int chunk) { return sums_[chunk]; }
    /// A_c^-1 P^T r.
    CoarseCorrection solve();

  private:
    struct Cells;
    struct Factor;

    void make_sums(int chunks);
    void place_nodes(const FineLevel& fine);
    void find_range(const Neighbours& n, int chunk);
    void assemble(const FineLevel& fine, int chunk);
    void collect();

    double size_;                  ///< edge of a cell, m
    std::vector<int> cell_;        ///< per node
    std::vector<int> wall_cell_;   ///< per boundary particle of the wall
    std::vector<int> cell_of_id_;  ///< per soil particle, by id; -1: none yet
    int chunks_ = 0;
    std::vector<CellSums> sums_;  ///< per chunk
    std::unique_ptr<Cells> cells_;
    std::unique_ptr<Factor> factor_;
};

}  // namespace runout
