#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <tiny_gltf.h>

namespace synth {

/// The elements of an accessor of a checked model as floats, sparse changes included; normalised
/// integers become [0, 1] or [-1, 1]. Instantiated for Vector2f, Vector3f and Vector4f; the
/// accessor has as many components. Throws vo::Error beginning with `place` for a sparse index
/// out of range or a value that is not finite.
template <typename Vector>
std::vector<Vector> read_vectors(const tinygltf::Model& model, int accessor,
                                 const std::string& place);

/// The same, component by component, for accessors of any type but matrices of bytes or shorts.
std::vector<float> read_numbers(const tinygltf::Model& model, int accessor,
                                const std::string& place);

/// The components of an accessor of unsigned integers.
std::vector<std::uint32_t> read_indices(const tinygltf::Model& model, int accessor,
                                        const std::string& place);

/// Whether the file holds numbers for it: glTF lets accessors without view, which are zeros, and
/// buffers without uri wait for extensions that fill them. The readers above give zeros for both.
bool holds_data(const tinygltf::Model& model, int accessor);

/// Throws vo::Error beginning with `place` for what the readers above throw it for, and for sparse
/// indices that do not increase. Allocates nothing for elements that are not sparse.
void check_data(const tinygltf::Model& model, int accessor, const std::string& place);

}  // namespace synth
