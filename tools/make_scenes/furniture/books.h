#pragma once

#include <cstdint>
#include <string>

#include "tools/make_scenes/model/model.h"

namespace scenes {

/// Returns books standing side by side over `length` metres, centred on the y axis, their spines
/// near z = 0 facing +z.
Mesh book_row(const std::string& name, double length, std::uint32_t seed);

/// Returns books lying on each other, spines to the front.
Mesh book_stack(const std::string& name, int count, std::uint32_t seed);

/// Returns a book that lies open with its pages up.
Mesh open_book();

}  // namespace scenes
