#pragma once

#include "tools/laboratory/test_run.h"
#include "tools/studies/study.h"

namespace tools {

struct BudgetSettings {
  RunSettings run;  ///< with all of its seeds
  int top = 3;      ///< imperfections whose shares are told apart; the others are one

  void validate() const;  ///< throws vo::Error
};

/// What of a scenario's errors each imperfection of its camera causes: the error with it alone, the
/// error with all but it, and its Shapley value, the mean of what it adds over all orders in which
/// the imperfections may be switched on. Shares and the error of a perfect camera sum to the whole.
/// Throws vo::Error when the camera is perfect, or where nothing could be measured.
StudyReport error_budget(const Scenario& scenario, const BudgetSettings& settings,
                         const vo::Progress& progress, const WaitObserver& waiting);

}  // namespace tools
