#pragma once

#include <algorithm>
#include <utility>

namespace vo {

struct DampedDescentOptions {
  int iterations = 0;
  double converged = 0;  ///< least gain of a step, as a share of the loss, to go on
};

/// Minimises `loss(state)` by Levenberg-Marquardt: `step(state, damping)` returns a candidate,
/// which replaces `state` if its loss is less; if not, the damping grows. Returns the final loss.
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
