#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

namespace vo {

/// Returns X with A X = B for a symmetric A (Cholesky's L D L^T), a column at a time: Eigen solves
/// for several columns by blocks, and adds in an order that depends on the processor's registers.
template <int N, int kColumns>
Eigen::Matrix<double, N, kColumns> solve_by_columns(const Eigen::Matrix<double, N, N>& A,
                                                    const Eigen::Matrix<double, N, kColumns>& B) {
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> decomposition(A);
  Eigen::Matrix<double, N, kColumns> X;
  for (Eigen::Index k = 0; k < kColumns; ++k) {
    X.col(k) = decomposition.solve(B.col(k));
  }
  return X;
}

/// The normal equations H delta = -b of N unknowns (Gauss-Newton): H is the sum of w J^T J and b
/// that of w J^T r over residuals r of weight w and Jacobian J. H is symmetric.
template <int N>
struct NormalEquations {
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;

  static constexpr Eigen::Index kSize = N == Eigen::Dynamic ? 0 : N;

  Matrix H = Matrix::Zero(kSize, kSize);
  Vector b = Vector::Zero(kSize);
  double cost = 0;  ///< sum of the robust losses where the residuals were linearized

  static NormalEquations zero(Eigen::Index unknowns) {
    return {Matrix::Zero(unknowns, unknowns), Vector::Zero(unknowns)};
  }

  /// Adds a residual, but for its loss. J is a column.
  void add_residual(const Vector& J, double r, double weight) {
    H.noalias() += weight * J * J.transpose();
    b.noalias() += weight * r * J;
  }

  /// Adds residuals, one for each row of J, but for their loss.
  template <typename Jacobian, typename Residuals>
  void add_residuals(const Eigen::MatrixBase<Jacobian>& J, const Eigen::MatrixBase<Residuals>& r,
                     double weight) {
    H += weight * J.transpose() * J;
    b += weight * J.transpose() * r;
  }

  void add(const NormalEquations& other, double weight) {
    H += weight * other.H;
    b += weight * other.b;
    cost += weight * other.cost;
  }

  /// Adds the equations of other unknowns, whose derivatives by these unknowns are J.
  template <int M, typename Jacobian>
  void add(const NormalEquations<M>& other, const Eigen::MatrixBase<Jacobian>& J,
           double weight = 1) {
    H += weight * J.transpose() * other.H * J;
    b += weight * J.transpose() * other.b;
    cost += weight * other.cost;
  }

  /// Returns delta.
  Vector step() const {
    const Vector solution = H.ldlt().solve(b);  // a nested expression would compile for seconds
    return -solution;
  }

  /// Returns the equations of the first K unknowns while the others stay.
  template <int K>
  NormalEquations<K> leading() const {
    return {H.template topLeftCorner<K, K>(), b.template head<K>(), cost};
  }

  /// Returns the equations of the last K unknowns while the others stay.
  template <int K>
  NormalEquations<K> trailing() const {
    return {H.template bottomRightCorner<K, K>(), b.template tail<K>(), cost};
  }

  /// Returns X with H_ee X = `right`, where H_ee is the block of the last E unknowns.
  template <int E, typename Right>
  Eigen::Matrix<double, E, Right::ColsAtCompileTime> solve_trailing(
      const Eigen::MatrixBase<Right>& right) const {
    constexpr int kClosedForm = 4;  // rows up to which Eigen inverts without a decomposition
    const Eigen::Matrix<double, E, E> block = H.template bottomRightCorner<E, E>();
    if constexpr (E <= kClosedForm) {
      return block.inverse() * right;
    } else {
      return solve_by_columns<E, Right::ColsAtCompileTime>(block, right);
    }
  }

  /// Returns the equations of the other unknowns with the last E eliminated (Schur complement).
  template <int E>
  NormalEquations<N - E> eliminated() const {
    const Eigen::Matrix<double, E, N - E> coupling = H.template bottomLeftCorner<E, N - E>();
    const Eigen::Matrix<double, E, N - E> shares = solve_trailing<E>(coupling);
    return {H.template topLeftCorner<N - E, N - E>() - shares.transpose() * coupling,
            b.template head<N - E>() - shares.transpose() * b.template tail<E>(), cost};
  }

  /// Returns the step of the E eliminated unknowns that goes with a step of the others.
  template <int E>
  Eigen::Matrix<double, E, 1> eliminated_step(const Eigen::Matrix<double, N - E, 1>& others) const {
    const Eigen::Matrix<double, E, 1> right =
        b.template tail<E>() + H.template topRightCorner<N - E, E>().transpose() * others;
    return -solve_trailing<E>(right);
  }
};

/// Unknowns beside those of normal equations of which no residual sees two, as the depths of
/// points: their block of H is diagonal.
template <int Order = Eigen::ColMajor>
struct SeparateUnknowns {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Order>
      coupling;       ///< the block of H between the others and these, a column for each of these
  Eigen::VectorXd H;  ///< the diagonal
  Eigen::VectorXd b;

  /// Returns the step that goes with a step of the others.
  Eigen::VectorXd step_with(const Eigen::VectorXd& others) const {
    return -(b + coupling.transpose() * others).cwiseQuotient(H);
  }
};

}  // namespace vo
