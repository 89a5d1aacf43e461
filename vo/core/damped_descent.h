#pragma once

#include <algorithm>
#include <utility>

namespace vo {

struct DampedDescentOptions {
  int iterations = 0;
  double converged = 0;  ///< share of the loss; ends with a step that gains less
};

/// Levenberg and Marquardt's steps: `step(state, damping)` is the next state, taken where `loss` of
/// it is less and else tried again, shorter. Returns the loss that it ends with.
template <typename State, typename Step, typename Loss>
double descend(State& state, const Step& step, const Loss& loss,
               const DampedDescentOptions& options) {
  double least = loss(state);
  double damping = 1e-3;
  for (int i = 0; i < options.iterations; ++i) {
    State next = step(state, damping);
    const double reached = loss(next);
    if (!(reached < least)) {
      damping *= 8;
      continue;
    }
    const bool converged = least - reached < options.converged * least;
    state = std::move(next);
    least = reached;
    damping = std::max(damping * 0.3, 1e-9);
    if (converged) {
      break;
    }
  }
  return least;
}

}  // namespace vo
