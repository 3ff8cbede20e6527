// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `norm`: the length of a vector whose squares may under- or overflow.
#pragma once

#include <cmath>

#include <Eigen/Core>

namespace ltp {

/// The length of any finite vector that has one, from the smallest numbers to the largest; 0 for
/// the zero vector only. Where squares neither under- nor overflow it is Eigen's, to the last bit.
template <typename Vector>
double norm(const Eigen::MatrixBase<Vector>& vector) {
  // Squares of this size have lost nothing that counts.
  constexpr double kLeast = 1e-280;
  constexpr double kMost = 1e300;
  const double square = vector.squaredNorm();
  if (square > kLeast && square < kMost) return std::sqrt(square);
  const double most = vector.cwiseAbs().maxCoeff();
  if (!(most > 0.0) || !std::isfinite(most)) return std::sqrt(square);
  return most * (vector / most).norm();
}

}  // namespace ltp
