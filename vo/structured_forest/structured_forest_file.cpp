#include "vo/structured_forest/structured_forest_file.h"

#include <array>
#include <utility>
#include <vector>

#include <opencv2/core/persistence.hpp>

#include "vo/core/error.h"

namespace vo {
namespace {

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

ForestParameters read_parameters(const cv::FileNode& options) {
  require(options.isMap(), "options: expected a map");
  ForestParameters parameters;
  for (const auto& [key, value] : kParameterKeys) {
    const cv::FileNode node = options[key];
    require(node.isInt(), "options.", key, ": expected a whole number");
    parameters.*value = static_cast<int>(node);
  }
  return parameters;
}

bool has_type(const cv::FileNode& node, int /*type*/) {
  return node.isInt();
}

bool has_type(const cv::FileNode& node, float /*type*/) {
  return node.isInt() || node.isReal();
}

/// Reads a sequence of sequences of numbers, one for each tree, and joins them.
template <typename Number>
std::vector<Number> read_numbers(const cv::FileStorage& file, const char* key) {
  const cv::FileNode trees = file[key];
  require(trees.isSeq(), key, ": expected a sequence of sequences of numbers");
  std::vector<Number> numbers;
  for (const cv::FileNode& tree : trees) {
    require(tree.isSeq(), key, ": expected a sequence of sequences of numbers");
    for (const cv::FileNode& node : tree) {
      require(has_type(node, Number{}), key, "[", numbers.size(), "]: expected a number");
      numbers.push_back(static_cast<Number>(node));
    }
  }
  return numbers;
}

StructuredForest read_forest(const cv::FileStorage& file) {
  const ForestParameters parameters = read_parameters(file["options"]);
  return {parameters,
          {.children = read_numbers<int>(file, "childs"),
           .feature_ids = read_numbers<int>(file, "featureIds"),
           .thresholds = read_numbers<float>(file, "thresholds"),
           .edge_boundaries = read_numbers<int>(file, "edgeBoundaries"),
           .edge_bins = read_numbers<int>(file, "edgeBins")}};
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
  require(std::filesystem::is_regular_file(path), path.string(), ": no such file");
  try {
    const cv::FileStorage file(path.string(), cv::FileStorage::READ);
    require(file.isOpened(), "expected a structured forest as .yml or .yml.gz");
    return read_forest(file);
  } catch (const cv::Exception& error) {
    fail(path.string(), ": expected a structured forest as .yml or .yml.gz: ", error.err);
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what(), error.kind());
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
