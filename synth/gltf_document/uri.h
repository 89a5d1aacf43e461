#pragma once

#include <filesystem>
#include <string>

#include "synth/gltf_document/gltf_file.h"

namespace synth {

/// Whether the URI holds its data itself.
bool is_data_uri(const std::string& uri);

struct UriData {
  std::string media_type;  ///< like "image/png", empty if the URI names none
  Bytes bytes;
};

/// What a data URI holds, in base64 or percent-encoded (RFC 2397). Throws vo::Error beginning with
/// `place`.
UriData decode_data_uri(const std::string& uri, const std::string& place);

/// The file that a URI stands for, percent-decoded and below `folder`. Opens nothing. Throws
/// vo::Error beginning with `place` when the URI leads out of the folder or has a scheme.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, const std::string& uri,
                                  const std::string& place);

}  // namespace synth
