#include "vo/core/inplace_vector.h"

#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace {

using Shared = std::shared_ptr<int>;

TEST(InplaceVector, HoldsWhatWasAppendedAndNoMoreThanItsCapacity) {
  vo::InplaceVector<int, 3> values;
  EXPECT_TRUE(values.empty());
  for (const int value : {5, 6, 7}) {
    values.push_back(value);
  }
  EXPECT_EQ(std::vector<int>(values.begin(), values.end()), (std::vector{5, 6, 7}));
  EXPECT_THROW(values.push_back(8), std::length_error);
  values.pop_back();
  EXPECT_EQ(values.size(), 2U);
  EXPECT_EQ(values.front(), 5);
  EXPECT_EQ(values.back(), 6);
}

/// Every element is destroyed once: nobody but the vectors holds it, and they are gone.
TEST(InplaceVector, CopiesAndMovesItsElements) {
  const auto element = std::make_shared<int>(1);
  {
    vo::InplaceVector<Shared, 4> first;
    first.push_back(element);
    first.push_back(element);
    vo::InplaceVector<Shared, 4> second = first;
    EXPECT_EQ(element.use_count(), 5);
    second.pop_back();
    first = second;
    EXPECT_EQ(element.use_count(), 3);
    const vo::InplaceVector<Shared, 4> third = std::move(first);
    EXPECT_EQ(element.use_count(), 3);
    EXPECT_EQ(third.front(), element);
  }
  EXPECT_EQ(element.use_count(), 1);
}

}  // namespace
