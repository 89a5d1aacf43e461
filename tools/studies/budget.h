#pragma once

#include "tools/studies/study.h"
#include "tools/trials/test_run.h"

namespace tools {

struct BudgetSettings {
  RunSettings run;  ///< settings of the trials, including the number of seeds
  int top = 3;      ///< imperfections with a share of their own; the others share one

  void validate() const;  ///< throws vo::Error on an invalid setting
};

/// Attributes a scenario's errors to its camera's imperfections: for each, the error with it alone,
/// the error with all but it, and its Shapley value, the mean of what it adds over all orders in
/// which the imperfections may be switched on. The Shapley values and the error of a perfect camera
/// sum to the total error. Throws vo::Error when the camera is perfect, or when a trial fails.
StudyReport error_budget(const Scenario& scenario, const BudgetSettings& settings,
                         const vo::Progress& progress, const vo::WaitObserver& waiting);

}  // namespace tools
