#pragma once

#include <filesystem>
#include <string>

#include "synth/gltf_document/gltf_file.h"

namespace synth {

/// Returns whether the URI is a data URI, which holds its data itself.
bool is_data_uri(const std::string& uri);

struct UriData {
  std::string media_type;  ///< like "image/png", empty if the URI names none
  Bytes bytes;
};

/// Decodes a data URI, base64 or percent-encoded (RFC 2397). Throws vo::Error beginning with
/// `place` if it is malformed.
UriData decode_data_uri(const std::string& uri, const std::string& place);

/// Returns the path below `folder` that a percent-encoded URI names. Opens nothing. Throws
/// vo::Error beginning with `place` if the URI leads out of the folder, by itself or by a symbolic
/// link, or has a scheme.
std::filesystem::path resolve_uri(const std::filesystem::path& folder, const std::string& uri,
                                  const std::string& place);

}  // namespace synth
