#pragma once

#include <cstdint>

namespace runout {

/// Rows of the pair lists are worked on in slices of this many lanes.
constexpr int lanes = 16;

/// Slices of pair rows that one thread works on at a time.
constexpr int slices_per_block = 8;
constexpr int rows_per_block = slices_per_block * lanes;

/// The pairs of one block as plain arrays: entry k of lane l of slice s stands at offset[s] + 16 k + l.
struct PairRows {
    int first_row = 0;
    int slices = 0;                        ///< that hold rows
    const int* offset = nullptr;           ///< slices + 1
    const std::int32_t* column = nullptr;  ///< node of the neighbour
    const float* gx = nullptr;             ///< V gradW, 1/m
    const float* gy = nullptr;
    const float* stiffness = nullptr;
};

/// Plain (uncorrected) velocity gradients of the rows of one block, dv_row / dx_column, 1/s.
struct VelocityGradients {
    float xx[rows_per_block], xy[rows_per_block], yx[rows_per_block], yy[rows_per_block];
};

/// One projected iteration of the friction, node arrays; see Friction.
struct StressUpdate {
    const float* vx = nullptr;  ///< trial velocity, m/s
    const float* vy = nullptr;
    const float* correction[4] = {};  ///< inverse moment matrix of eq. 9, row-major
    const float* strength = nullptr;  ///< p sin(phi), Pa
    float step = 0;                   ///< 2 r, Pa s
    float momentum = 0;
    float* sxx = nullptr;  ///< Pa
    float* sxy = nullptr;
    float* ahead_sxx = nullptr;  ///< extrapolated by `momentum`
    float* ahead_sxy = nullptr;
};

/// A list of pairs as plain arrays: separations in, geometry out.
struct PairGeometry {
    int count = 0;
    const double* dx = nullptr;  ///< x_i - x_j, m
    const double* dy = nullptr;
    const double* r2 = nullptr;  ///< within the support
    double* gx = nullptr;        ///< V gradW, 1/m
    double* gy = nullptr;
    double* stiffness = nullptr;  ///< k_ij
    double* kernel = nullptr;     ///< W, 1/m2
};

/// Constants of the kernel and of k_ij that the geometry needs, see WendlandKernel and Discretisation.
struct GeometryConstants {
    double inverse_h = 0;        ///< 1/m
    double value_scale = 0;      ///< of W
    double gradient_scale = 0;   ///< of V gradW / x
    double stiffness_scale = 0;  ///< of k r^2-free part
    double eta2 = 0;             ///< m2
};

/// The sums over pairs that the engine spends its time in. Node arrays hold soil, padding, then active
/// boundary particles; results are written for every lane of the block's rows. Signs as in the paper:
/// compression positive. Each row is summed in its own order, so every instruction set gives the same bits.
struct PairKernels {
    /// force = sum_j (s_i + s_j) . V gradW, Pa/m: divergence of the deviatoric stress, eq. 3. Plain, not
    /// renormalised gradients: the renormalised form drags thin layers (false friction).
    void (*stress_divergence)(const PairRows& rows, const float* sxx, const float* sxy, float* force_x,
                              float* force_y);
    /// force = sum_j (p_i + p_j) V gradW, Pa/m: pressure gradient, eq. 4.
    void (*pressure_gradient)(const PairRows& rows, const double* pressure, double* force_x, double* force_y);
    /// div = sum_j V (v_j - v_i) . gradW, 1/s; the negative adjoint of `pressure_gradient`.
    void (*velocity_divergence)(const PairRows& rows, const double* vx, const double* vy, double* divergence);
    /// gradient = sum_j V (v_j - v_i) (x) gradW.
    void (*velocity_gradient)(const PairRows& rows, const float* vx, const float* vy,
                              VelocityGradients& gradients);
    /// s <- bound(ahead + 2 r e(v)), |s| <= strength; then ahead <- s + momentum (s - old s). For the block's
    /// rows.
    void (*update_stress)(const PairRows& rows, const StressUpdate& update);
    /// out = sum_j k_ij x_j.
    void (*stiffness_product)(const PairRows& rows, const double* x, double* out);
    /// Kernel, gradient and k of each pair of a list.
    void (*pair_geometry)(const PairGeometry& pairs, const GeometryConstants& constants);
};

/// The fastest kernels this machine can run.
const PairKernels& pair_kernels();

// One table an instruction set, each compiled in a file of its own.
extern const PairKernels pair_kernels_baseline;
extern const PairKernels pair_kernels_avx2;
extern const PairKernels pair_kernels_avx512;

}  // namespace runout
