#pragma once

#include <cstdint>

namespace runout {

enum class InstructionSet;  // its header is not for files that are compiled with wide instructions

/// Rows of the pair lists are worked on in slices of this many lanes.
constexpr int lanes = 16;

/// Slices of pair rows that one thread works on at a time.
constexpr int slices_per_block = 8;
constexpr int rows_per_block = slices_per_block * lanes;

/// Pairs as plain arrays.
struct PairArrays {
    const std::int32_t* column = nullptr;  ///< node of the neighbour
    const float* gx = nullptr;             ///< V gradW, 1/m
    const float* gy = nullptr;
    const float* stiffness = nullptr;  ///< k_ij of the pressure matrix
};

/// Pairs of slices that follow each other in a block. Entry k of lane l of slice s stands at offset[s] + 16 k
/// + l.
struct PairRows : PairArrays {
    int first_row = 0;
    int slices = 0;               ///< how many hold rows
    const int* offset = nullptr;  ///< slices + 1
    PairArrays next;              ///< of the next block, if any, to be fetched into the cache meanwhile
};

/// Two numbers of a node that are always needed together, such as vx and vy or sxx and sxy, in one word. The
/// pair loops spend their time on loading scattered neighbours, and so load once in place of twice.
struct alignas(8) FloatPair {
    float x = 0, y = 0;
};

/// Plain (uncorrected) velocity gradients of the rows of one block, dv_row / dx_column, 1/s.
struct VelocityGradients {
    float xx[rows_per_block], xy[rows_per_block], yx[rows_per_block], yy[rows_per_block];
};

/// One projected iteration of the friction, node arrays; see Friction.
struct StressUpdate {
    const float* correction[4] = {};  ///< inverse moment matrix of eq. 9, row-major
    const float* strength = nullptr;  ///< p sin(phi), Pa
    float step = 0;                   ///< 2 r, Pa s
    float momentum = 0;
    FloatPair* stress = nullptr;  ///< sxx and sxy, Pa
    FloatPair* ahead = nullptr;   ///< stress extrapolated by `momentum`
};

/// Rotation of the stress with the soil, node arrays; see Friction.
struct StressRotation {
    const float* correction[4] = {};  ///< inverse moment matrix of eq. 9, row-major
    float dt = 0;                     ///< s
    FloatPair* stress = nullptr;      ///< sxx and sxy, Pa
};

/// Asks which particles of some ranges are near a point.
struct NearQuery {
    static constexpr int max_ranges = 3;
    double x = 0, y = 0;  ///< m
    int ranges = 0;
    int first[max_ranges] = {};
    int last[max_ranges] = {};
};

/// Asks which of the candidates are near each row of a slice, the row itself left out. Only for rows whose
/// bit in `asking` is set.
struct SliceQuery {
    int first_row = 0;  ///< the slice's first
    std::uint32_t asking = 0;
    int count = 0;  ///< of candidates
    const std::int32_t* candidate = nullptr;
};

/// Answer to a SliceQuery: entry e of lane l stands at 16 e + l.
struct SliceNear {
    int* count = nullptr;  ///< entries of each lane
    std::int32_t* column = nullptr;
    FloatPair* separation = nullptr;  ///< x_row - x_column, m
};

/// A list of pairs as plain arrays: separations in, geometry out.
struct PairGeometry {
    int count = 0;
    const float* dx = nullptr;  ///< x_i - x_j, m
    const float* dy = nullptr;
    float* gx = nullptr;  ///< V gradW, 1/m
    float* gy = nullptr;
    float* stiffness = nullptr;     ///< k_ij
    float* kernel_value = nullptr;  ///< W, 1/m2
};

/// The pairs of one slice: entry e of lane l stands at 16 e + l. Separations in, geometry out; a separation
/// of one support is no pair and comes out as zeros.
struct SliceGeometry {
    int width = 0;                          ///< entries a lane
    const FloatPair* separation = nullptr;  ///< x_i - x_j, m
    float* gx = nullptr;                    ///< V gradW, 1/m
    float* gy = nullptr;
    float* stiffness = nullptr;  ///< k_ij
};

/// Sums over the pairs of each lane of a slice, see RowSums.
struct SliceSums {
    float kernel_sum[lanes], stiffness[lanes], surface_x[lanes], surface_y[lanes], xx[lanes], xy[lanes],
        yy[lanes];
};

/// Constants of the kernel and of k_ij that the geometry needs, see WendlandKernel and Discretisation.
struct GeometryConstants {
    float inverse_h = 0;        ///< 1/m
    float value_scale = 0;      ///< of W
    float gradient_scale = 0;   ///< of V gradW / x
    float stiffness_scale = 0;  ///< of k r^2-free part
    float eta2 = 0;             ///< m2
};

/// The compute kernels: the sums over pairs that the engine spends its time in. Node arrays hold soil,
/// padding, then active boundary particles. Results are written for every lane of the rows. Compression is
/// positive, as in the paper. Each row is summed in its own order, so that every instruction set gives the
/// same bits.
struct PairKernels {
    /// force = sum_j (s_i + s_j) . V gradW, Pa/m: divergence of the deviatoric stress, eq. 3. Plain, not
    /// renormalised gradients: the renormalised form drags thin layers (false friction).
    void (*stress_divergence)(const PairRows& rows, const FloatPair* stress, FloatPair* force);
    /// force = sum_j (p_i + p_j) V gradW, Pa/m: pressure gradient, eq. 4.
    void (*pressure_gradient)(const PairRows& rows, const double* pressure, double* force_x, double* force_y);
    /// div = sum_j V (v_j - v_i) . gradW, 1/s; the negative adjoint of `pressure_gradient`.
    void (*velocity_divergence)(const PairRows& rows, const FloatPair* velocity, double* divergence);
    /// gradient = sum_j V (v_j - v_i) (x) gradW.
    void (*velocity_gradient)(const PairRows& rows, const FloatPair* velocity, VelocityGradients& gradients);
    /// s <- bound(ahead + 2 r e(v)), |s| <= strength; then ahead <- s + momentum (s - old s), with the plain
    /// gradients of the trial velocity. For the block's rows.
    void (*update_stress)(const PairRows& rows, const VelocityGradients& gradients,
                          const StressUpdate& update);
    /// Turns s by the spin of the soil over dt (Jaumann; the rational form of the rotation keeps |s|), with
    /// the plain gradients of its velocity. For the block's rows.
    void (*rotate_stress)(const PairRows& rows, const VelocityGradients& gradients,
                          const StressRotation& rotation);
    /// out = d_i x_i - sum_j k_ij x_j: rows of the pressure matrix with the given diagonal.
    void (*pressure_product)(const PairRows& rows, const double* diagonal, const double* x, double* out);
    /// Writes index and separation of all that is nearer than the square root of `support2`, in order, and
    /// returns how many. There must be room for all of the ranges and one more.
    int (*select_near)(const double* x, const double* y, const NearQuery& query, float support2,
                       std::int32_t* column, float* dx, float* dy);
    /// The same for the rows of a slice that ask, each in the order of the candidates. The counts of the
    /// other rows are left as they are. There must be room for as many entries as candidates, and one more.
    void (*select_near_slice)(const double* x, const double* y, const SliceQuery& query, float support2,
                              const SliceNear& near);
    /// Kernel, gradient and k of each pair of a list.
    void (*pair_geometry)(const PairGeometry& pairs, const GeometryConstants& constants);
    /// Gradient and k of each pair of a slice, and its sums.
    void (*slice_geometry)(const SliceGeometry& slice, const GeometryConstants& constants, SliceSums& sums);
};

/// The kernels of instruction_set(). The first call throws InputError where that does.
const PairKernels& pair_kernels();
/// The kernels of one instruction set, which the machine must have.
const PairKernels& pair_kernels(InstructionSet set);

// One table an instruction set, each compiled in a file of its own.
extern const PairKernels pair_kernels_baseline;
extern const PairKernels pair_kernels_avx2;
extern const PairKernels pair_kernels_avx512;

}  // namespace runout
