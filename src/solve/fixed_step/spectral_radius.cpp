#include "solve/fixed_step/spectral_radius.hpp"

#include <Eigen/Eigenvalues>

#include <limits>

namespace sigmasweep {

double spectral_radius(const StepMap& map) {
  // Sizes are told at run time: unrolled, this would take a minute to compile.
  constexpr int most = StepMap::max_size;
  using Matrix = Eigen::Matrix<StepMap::Wide, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
  const auto size = static_cast<Eigen::Index>(map.size());
  Matrix matrix(size, size);
  for (std::size_t i = 0; i < map.size(); ++i)
    for (std::size_t j = 0; j < map.size(); ++j)
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = map(i, j);
  if (!matrix.allFinite()) return std::numeric_limits<double>::infinity();
  return static_cast<double>(Eigen::EigenSolver<Matrix>(matrix, false).eigenvalues().cwiseAbs().maxCoeff());
}

}  // namespace sigmasweep
