#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <tiny_gltf.h>

namespace synth {

/// Reads the elements of an accessor of a checked model as floats, sparse values included;
/// normalised integers become [0, 1] or [-1, 1]. Instantiated for Vector2f, Vector3f and Vector4f,
/// which must match the accessor's type. Throws vo::Error beginning with `place` for sparse indices
/// that are out of range or do not increase, and for values that are not finite.
template <typename Vector>
std::vector<Vector> read_vectors(const tinygltf::Model& model, int accessor,
                                 const std::string& place);

/// Reads the components of an accessor as floats, element by element, as read_vectors does. The
/// accessor may be of any type but matrices of bytes or shorts.
std::vector<float> read_numbers(const tinygltf::Model& model, int accessor,
                                const std::string& place);

/// Reads the components of an accessor of unsigned integers. Throws vo::Error beginning with
/// `place` for sparse indices that are out of range or do not increase.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor,
                                        const std::string& place);

/// Returns whether the file holds an accessor's data. glTF allows accessors without a buffer view
/// and buffers without a uri, which extensions may fill; they are read as zeros.
bool holds_data(const tinygltf::Model& model, int accessor);

/// Throws vo::Error beginning with `place` if the accessor has wrong sparse indices or floats that
/// are not finite. Allocates nothing for elements that are not sparse.
void check_data(const tinygltf::Model& model, int accessor, const std::string& place);

}  // namespace synth
