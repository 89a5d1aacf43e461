#pragma once

#include <filesystem>
#include <string>

#include "vo/rigs/rig.h"
#include "vo/text_files/toml_file.h"

namespace vo {

/// Reads a table [[projector]] of a rig's file in a folder. Throws Error naming file, line and
/// projector for what is missing, unknown or out of range.
RigProjector read_rig_projector(const TomlRecord& record, const std::filesystem::path& folder);

/// Returns a projector as TOML that `read_rig_projector` reads.
std::string format_rig_projector(const RigProjector& projector);

}  // namespace vo
