#pragma once

#include <functional>
#include <string_view>

namespace vo {

/// Receives one value of a document, with the key that it follows.
using VisitForestValue = std::function<void(std::string_view key, std::string_view value)>;

/// Visits all values of a document of OpenCV's FileStorage, YAML, JSON or XML, in their order;
/// those of a list follow the key of the list. Values are views into `text`. Throws Error naming
/// the line where a list, a string or a tag does not end.
void for_each_forest_value(std::string_view text, const VisitForestValue& visit);

}  // namespace vo
