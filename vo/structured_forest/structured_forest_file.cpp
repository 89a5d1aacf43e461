#include "vo/structured_forest/structured_forest_file.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <functional>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <opencv2/core/persistence.hpp>

#include "vo/archives/gzip.h"
#include "vo/core/error.h"
#include "vo/files/input.h"
#include "vo/structured_forest/forest_text.h"

namespace vo {
namespace {

constexpr std::size_t kMaxForestBytes = 500'000'000;

struct ParameterKey {
  const char* key;
  int ForestParameters::*value;
};

constexpr std::array kParameterKeys = {
    ParameterKey{"stride", &ForestParameters::stride},
    ParameterKey{"shrinkNumber", &ForestParameters::shrink},
    ParameterKey{"patchSize", &ForestParameters::patch_size},
    ParameterKey{"patchInnerSize", &ForestParameters::inner_size},
    ParameterKey{"numberOfGradientOrientations", &ForestParameters::orientations},
    ParameterKey{"gradientSmoothingRadius", &ForestParameters::gradient_smoothing},
    ParameterKey{"regFeatureSmoothingRadius", &ForestParameters::regular_smoothing},
    ParameterKey{"ssFeatureSmoothingRadius", &ForestParameters::similarity_smoothing},
    ParameterKey{"gradientNormalizationRadius", &ForestParameters::gradient_normalization},
    ParameterKey{"selfsimilarityGridSize", &ForestParameters::grid_size},
    ParameterKey{"numberOfTrees", &ForestParameters::trees},
    ParameterKey{"numberOfTreesToEvaluate", &ForestParameters::trees_to_evaluate},
};

/// The values of a model, read one after the other.
class ForestReader {
 public:
  ForestReader() {
    for (const auto& [key, value] : kParameterKeys) {
      const std::string name = concat("options.", key);
      add(key, [this, name, value = value](std::string_view text) {
        parameters_.*value = parse<int>(text, name, "a whole number");
      });
    }
    add_list("childs", nodes_.children);
    add_list("featureIds", nodes_.feature_ids);
    add_list("thresholds", nodes_.thresholds);
    add_list("edgeBoundaries", nodes_.edge_boundaries);
    add_list("edgeBins", nodes_.edge_bins);
  }
  ForestReader(const ForestReader&) = delete;
  ForestReader& operator=(const ForestReader&) = delete;
  ForestReader(ForestReader&&) = delete;
  ForestReader& operator=(ForestReader&&) = delete;
  ~ForestReader() = default;

  /// Takes a value; one of an unknown key is left out.
  void read(std::string_view key, std::string_view text) {
    const auto member = members_.find(key);
    if (member != members_.end()) {
      ++member->second.values;
      member->second.read(text);
    }
  }

  StructuredForest forest() {
    for (const auto& [key, value] : kParameterKeys) {
      require(members_.at(key).values == 1, "options.", key, ": expected a whole number");
    }
    for (const auto& [key, member] : members_) {
      require(member.values > 0, key, ": expected a sequence of sequences of numbers");
    }
    return {parameters_, std::move(nodes_)};
  }

 private:
  struct Member {
    std::function<void(std::string_view text)> read;
    std::size_t values = 0;  ///< that have been read
  };

  template <typename Number>
  static Number parse(std::string_view text, const std::string& name, const char* expected) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    require(error == std::errc() && end == text.data() + text.size(), name, ": expected ", expected,
            ", got '", text.substr(0, 40), "'");
    return number;
  }

  void add(std::string_view key, std::function<void(std::string_view text)> read) {
    members_.emplace(key, Member{std::move(read)});
  }

  void add_list(const char* key, std::vector<int>& list) {
    add(key, [key, &list](std::string_view text) {
      list.push_back(parse<int>(text, concat(key, "[", list.size(), "]"), "a number"));
    });
  }

  void add_list(const char* key, std::vector<float>& list) {
    add(key, [key, &list](std::string_view text) {
      const auto number = parse<double>(text, concat(key, "[", list.size(), "]"), "a number");
      list.push_back(static_cast<float>(number));
    });
  }

  ForestParameters parameters_;
  ForestNodes nodes_;
  std::map<std::string_view, Member> members_;
};

StructuredForest read_forest(std::string_view text) {
  ForestReader reader;
  for_each_forest_value(
      text, [&](std::string_view key, std::string_view value) { reader.read(key, value); });
  return reader.forest();
}

/// Writes one sequence for each tree; the last one also takes the numbers beyond the number of
/// nodes.
template <typename Number>
void write_numbers(cv::FileStorage& file, const char* key, const std::vector<Number>& numbers,
                   const ForestNodes& nodes, int trees) {
  const auto per_tree =
      static_cast<std::ptrdiff_t>(nodes.children.size()) / static_cast<std::ptrdiff_t>(trees);
  file << key << "[";
  for (int tree = 0; tree < trees; ++tree) {
    const auto begin = numbers.begin() + tree * per_tree;
    const auto end = tree + 1 == trees ? numbers.end() : begin + per_tree;
    file << std::vector<Number>(begin, end);
  }
  file << "]";
}

}  // namespace

StructuredForest read_structured_forest(const std::filesystem::path& path) {
  const std::string bytes = read_file(path, kMaxForestBytes);
  try {
    return read_forest(is_gzip(bytes) ? gunzip(bytes, kMaxForestBytes) : bytes);
  } catch (const Error& error) {
    throw Error(
        concat(path.string(), ": expected a structured forest as .yml or .yml.gz: ", error.what()),
        error.kind());
  }
}

std::string structured_forest_yaml(const StructuredForest& forest) {
  const ForestParameters& parameters = forest.parameters();
  const ForestNodes& nodes = forest.nodes();
  cv::FileStorage file(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  file << "options"
       << "{";
  for (const auto& [key, value] : kParameterKeys) {
    file << key << parameters.*value;
  }
  file << "}";
  write_numbers(file, "childs", nodes.children, nodes, parameters.trees);
  write_numbers(file, "featureIds", nodes.feature_ids, nodes, parameters.trees);
  write_numbers(file, "thresholds", nodes.thresholds, nodes, parameters.trees);
  write_numbers(file, "edgeBoundaries", nodes.edge_boundaries, nodes, parameters.trees);
  file << "edgeBins"
       << "[" << nodes.edge_bins << "]";
  return file.releaseAndGetString();
}

}  // namespace vo
